#pragma once

#include <string>
#include <vector>

#include "loco_dynamics/profile/height_table.hpp"
#include "loco_dynamics/profile/profile_points.hpp"
#include "rail_core/yaml_reader.hpp"

namespace loco {

/// How wheel and rail are put together.
struct WheelRailDimensions {
  double inclination = 40.0;       ///< the rail leans 1:inclination to the track's centre; 0: it stands upright
  double gauge_m = 1.435;          ///< between the gauge faces, 14 mm below the tops of the inclined rails
  double flange_back_m = 1.360;    ///< between the backs of both flanges; the taping lines are 70 mm further out
  double wheel_radius_m = 0.5335;  ///< at the taping line
};

/// One wheel on one rail, both sides of the track being alike: what a contact search needs. Profile frame: y to the
/// field side, z down (profile_points.hpp).
class WheelRailGeometry {
 public:
  /// Reads a map and finishes the reader. Keys: wheel (S1002, coned_1_20) or wheel_file (a CSV), rail (UIC60) or
  /// rail_file, inclination, gauge_mm, flange_back_mm; name is optional. Where anything is refused the answer is S1002
  /// on UIC60.
  static WheelRailGeometry read(rail::YamlReader reader, double wheel_radius_m);

  /// S1002 on UIC60.
  explicit WheelRailGeometry(const WheelRailDimensions& dimensions = {});

  /// Of points that readProfileCsv() or makeWheelPoints(), makeRailPoints() gave.
  WheelRailGeometry(const ProfilePoints& wheel, const ProfilePoints& rail, const WheelRailDimensions& dimensions);

  /// A dimension with which wheelset and track do not fit.
  struct Misfit {
    std::string key;  ///< gauge_mm or rail
    std::string rule;
  };
  /// Whether flanges fit between the rails, treads stand on them, and the centred wheelset touches with its treads.
  std::vector<Misfit> findMisfits() const;

  /// Rise of the rolling radius over that at the taping line where the flange, climbing, gets less steep than its
  /// largest angle: 15.7 mm for S1002, which has 70 degrees up to there.
  double computeClimbRise_m() const;

  const HeightTable& wheel() const { return wheel_; }  ///< from the flange's tip to the field side
  const HeightTable& rail() const { return rail_; }    ///< inclined, from its highest point
  double wheelRadius_m() const { return dimensions_.wheel_radius_m; }
  double tapingLine_m() const { return taping_line_m_; }  ///< from the axle's middle
  double railTop_m() const { return rail_top_m_; }        ///< highest point of the rail from the track's middle
  const WheelRailDimensions& dimensions() const { return dimensions_; }

 private:
  WheelRailDimensions dimensions_;
  HeightTable wheel_, rail_;
  double taping_line_m_, rail_top_m_;
  double flange_face_m_;  ///< from the taping line, 10 mm below it
};

}  // namespace loco
