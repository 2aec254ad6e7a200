#pragma once

#include <string>
#include <vector>

#include "loco_dynamics/profile/profile_file.hpp"

namespace loco {

/// Rules that the points of a file must keep, so that a slip of the pen does not become a plausible wheel. A rule that
/// makes no sense without another one is left out where that one is broken.
class ProfileCheck {
 public:
  ProfileCheck(const ProfilePoints& points, const std::vector<int>& lines, const std::string& file,
               rail::Problems& problems)
      : points_(points), lines_(lines), file_(file), problems_(problems) {}

  void check(ProfileKind kind);

 private:
  bool checkCount();
  bool checkUnit(double narrowest_mm, double widest_mm, double shallowest_mm, double deepest_mm);
  bool checkOrder(std::size_t from);
  void checkNeighbours(std::size_t from);
  void checkWheel();
  bool checkFlangeSide(std::size_t tip);
  void checkFlange(std::size_t tip);
  void checkFlangeBack(std::size_t tip);
  void checkTapingLine(std::size_t tip);
  void checkSmoothness(std::size_t from);
  void checkRail();
  void refuse(const std::string& column, std::size_t point, double value_mm, const std::string& rule);
  void refuse(const std::string& rule) { problems_.add(file_, "", rule); }

  const ProfilePoints& points_;
  const std::vector<int>& lines_;
  const std::string& file_;
  rail::Problems& problems_;
};

}  // namespace loco
