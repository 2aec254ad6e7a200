#include "loco_dynamics/bogie_in_curve.hpp"

#include <string>

#include "rail_core/message_number.hpp"

namespace loco {

namespace {

constexpr double kFlangeDepth_m = 10e-3;  // below the taping line: where a flange's thickness is measured, UIC 510-2

struct Fit {
  double wheelbase_m, flange_play_m, smallest_m;
  std::string rule() const {
    return "must be at least " + rail::messageNumber(smallest_m, rail::Rounding::kUp) +
           " m: a bogie with a wheelbase of " + rail::messageNumber(wheelbase_m) + " m, whose flanges have " +
           rail::messageNumber(1e3 * flange_play_m) + " mm of play between the rails, fits into no tighter curve";
  }
};

void refuseCurves(rail::YamlReader reader, const Fit& fit, double tightest_m) {
  if (reader.has("table")) {
    reader.refuseKey("table", "has a radius_m of " + rail::messageNumber(tightest_m) + ", " + fit.rule());
    return;
  }
  for (rail::YamlReader& curve : reader.maps("curves"))
    if (curve.number("radius_m", rail::positive()) < fit.smallest_m) curve.refuse("radius_m", fit.rule());
}

}  // namespace

double computeFlangePlay_m(const WheelRailGeometry& geometry) {
  double below_m = geometry.wheel().begin_m(), above_m = 0.0;  // the flange's tip and the taping line
  constexpr int kHalvings = 40;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle_m = 0.5 * (below_m + above_m);
    (geometry.wheel().at(middle_m).z_m > kFlangeDepth_m ? below_m : above_m) = middle_m;
  }
  return geometry.dimensions().gauge_m - 2.0 * (geometry.tapingLine_m() + below_m);
}

double computeSmallestRadius_m(double wheelbase_m, double flange_play_m) {
  return wheelbase_m * wheelbase_m / (8.0 * flange_play_m);
}

std::shared_ptr<const rail::Track> readTrackForBogies(rail::YamlReader& root, const LocoStructure& structure,
                                                      double flange_play_m) {
  const std::size_t before = root.problems().count();
  auto track = std::make_shared<const rail::Track>(rail::Track::read(root.map("track")));
  if (root.problems().count() != before) return nullptr;
  const double wheelbase_m = structure.bodies[BodyLayout::wheelset(0)].p_T.x() -
                             structure.bodies[BodyLayout::wheelset(BodyLayout::kAxlesPerBogie - 1)].p_T.x();
  const Fit fit{wheelbase_m, flange_play_m, computeSmallestRadius_m(wheelbase_m, flange_play_m)};
  if (track->largestCurvature() * fit.smallest_m <= 1.0) return track;
  refuseCurves(root.map("track"), fit, 1.0 / track->largestCurvature());
  return nullptr;
}

}  // namespace loco
