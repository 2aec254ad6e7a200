#pragma once

#include <optional>
#include <string>
#include <vector>

#include "decimated_series.hpp"
#include "loco_dynamics/planar_contact.hpp"

namespace viz {

/// Adhesion over creep of a 2D locomotive's axle, by the very contact that the simulation computes with
/// (loco::PlanarContact). A 3D locomotive has none: its contact ellipses move with the wheelsets.
class CreepCurve {
 public:
  /// @param resolved    the run's scenario, as /train/configuration gives it
  /// @param locomotive  from 1 at the head
  /// @param why_not     why nothing is returned: another model, or what is wrong with the text
  static std::optional<CreepCurve> read(const std::string& resolved, int locomotive, std::string& why_not);

  /// What decides on the curve besides creep.
  struct Situation {
    double axle_load_N = 0.0, speed_mps = 0.0, place_m = 0.0;
    bool sanding = false;
  };
  double computeAdhesion(double creep, const Situation& now) const;
  /// Points from `least` to `largest` creep [-], finest at 0, which both sides share.
  std::vector<Point> computePoints(double least, double largest, const Situation& now) const;

 private:
  explicit CreepCurve(const loco::PlanarContact& contact) : contact_(contact) {}
  loco::PlanarContact contact_;
};

}  // namespace viz
