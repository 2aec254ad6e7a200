#pragma once

#include <string>

#include "loco_dynamics/profile/height_table.hpp"
#include "loco_dynamics/profile/profile_points.hpp"
#include "rail_core/problems.hpp"
#include "rail_core/yaml_reader.hpp"

namespace loco {

/// A profile and where it came from, for messages.
struct SourcedProfile {
  ProfilePoints points;
  std::string file;  ///< or its name
};

/// How wheel and rail are put together.
struct WheelRailDimensions {
  double inclination = 40.0;      ///< the rail leans 1:inclination to the track's centre; 0: it stands upright
  double gauge_m = 1.435;         ///< between the gauge faces, 14 mm below the tops of the inclined rails
  double flange_back_m = 1.360;   ///< between the backs of both flanges; the taping lines are 70 mm further out
  double wheel_radius_m = 0.5335; ///< at the taping line
};

/// One wheel on one rail, both sides of the track being alike: what a contact search needs. Profile frame: y to the
/// field side, z down (profile_points.hpp).
class WheelRailGeometry {
 public:
  /// Reads a map: wheel (S1002, coned_1_20) or wheel_file (CSV), rail (UIC60) or rail_file, inclination, gauge_mm,
  /// flange_back_mm; name is optional. Finishes the reader. Where anything is refused the answer is the default pair.
  static WheelRailGeometry read(rail::YamlReader reader, double wheel_radius_m);

  /// Puts checked profiles together. What does not fit is added to `problems` under `place`.
  static WheelRailGeometry make(const SourcedProfile& wheel, const SourcedProfile& rail,
                                const WheelRailDimensions& dimensions, const std::string& place, rail::Problems& problems);

  /// S1002 on UIC60.
  explicit WheelRailGeometry(const WheelRailDimensions& dimensions = {});

  const HeightTable& wheel() const { return wheel_; }  ///< from the flange's tip to the field side
  const HeightTable& rail() const { return rail_; }    ///< inclined, from its highest point
  double wheelRadius_m() const { return dimensions_.wheel_radius_m; }
  double tapingLine_m() const { return taping_line_m_; }  ///< from the axle's middle
  double railTop_m() const { return rail_top_m_; }        ///< highest point of the rail from the track's middle
  const WheelRailDimensions& dimensions() const { return dimensions_; }

 private:
  WheelRailGeometry(const ProfilePoints& wheel, const ProfilePoints& rail, const WheelRailDimensions& dimensions);

  WheelRailDimensions dimensions_;
  HeightTable wheel_, rail_;
  double taping_line_m_, rail_top_m_;
};

}  // namespace loco
