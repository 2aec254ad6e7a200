#include "loco_dynamics/profile/standing_wheelset.hpp"

#include <cmath>

#include "loco_dynamics/contact/creep_law.hpp"

namespace loco {

namespace {

constexpr std::array<Side, 2> kSides{Side::kLeft, Side::kRight};
constexpr int kHalvings = 45;
// Heights of a wheel over its nominal one between which the pose is sought: a flange's tip on the rail is 30 mm up.
constexpr double kLowest_m = -20e-3;
constexpr double kHighest_m = 60e-3;

/// Heights of the axle above both taping lines -> pose.
WheelsetPose poseOf(const StandingCase& given, double arm_m, const std::array<double, 2>& height_m) {
  return {given.y_m, 0.5 * (height_m[0] + height_m[1]), std::asin((height_m[0] - height_m[1]) / (2.0 * arm_m)),
          given.yaw_rad};
}

CreepLaw makeCreepLaw(double friction) {
  CreepLawParameters parameters;
  parameters.method = CreepMethod::kFastsim;
  parameters.friction = {friction, 1.0, 0.0};
  parameters.cells = parameters.strips = 20;
  return CreepLaw(parameters);
}

}  // namespace

WheelsetStand::WheelsetStand(const WheelRailGeometry& geometry, const Elasticity& elasticity)
    : search_(geometry), elasticity_(elasticity) {}

LoadedWheel WheelsetStand::loadWheel(Side side, const WheelsetPose& pose, const StandingCase& given,
                                     double mean_radius_m) const {
  LoadedWheel wheel;
  std::array<ContactRegion, kMostContacts> regions;
  wheel.count = search_.find(side, pose, regions);
  const double shear_Pa = elasticity_.young_Pa / (2.0 * (1.0 + elasticity_.poisson));
  for (std::size_t i = 0; i < wheel.count; ++i) {
    LoadedPatch& patch = wheel.patch[i];
    const ContactRegion& region = patch.region = regions[i];
    const HertzContact hertz(region.curvature, elasticity_);
    const double whole_N = hertz.computeNormalForce(region.approach_m);
    patch.normal_N = region.share * whole_N;
    patch.ellipse = hertz.computeEllipse(whole_N);
    if (given.friction == 0.0) continue;
    Creepage creepage;  // (G8)
    creepage.xi_x = 1.0 - region.rolling_radius_m / mean_radius_m;
    creepage.xi_y = -given.yaw_rad / std::cos(region.angle_rad);
    creepage.phi_1pm = -std::sin(region.angle_rad) / region.rolling_radius_m;
    const CreepForce force = makeCreepLaw(given.friction)
                                 .computeForce(makeContactPatch(patch.ellipse.a_m, patch.ellipse.b_m, whole_N, shear_Pa,
                                                                elasticity_.poisson),
                                               creepage);
    patch.creep_x_N = region.share * force.x_N;
    patch.creep_y_N = region.share * force.y_N;
  }
  return wheel;
}

double WheelsetStand::computeVertical(Side side, const WheelsetPose& pose, const StandingCase& given,
                                      double mean_radius_m) const {
  const LoadedWheel wheel = loadWheel(side, pose, given, mean_radius_m);
  double vertical_N = 0.0;
  for (std::size_t i = 0; i < wheel.count; ++i) {
    const LoadedPatch& patch = wheel.patch[i];
    vertical_N +=
        patch.normal_N * std::cos(patch.region.angle_rad) + patch.creep_y_N * std::sin(patch.region.angle_rad);
  }
  return vertical_N;
}

/// V/omega at which the creep forces turn the wheelset neither way: they fall as it spins slower.
double WheelsetStand::findMeanRadius(const WheelsetPose& pose, const StandingCase& given) const {
  double low_m = 0.9 * search_.geometry().wheelRadius_m(), high_m = 1.1 * search_.geometry().wheelRadius_m();
  for (int i = 0; i < kHalvings; ++i) {
    const double middle_m = 0.5 * (low_m + high_m);
    double moment_Nm = 0.0;
    for (const Side side : kSides) {
      const LoadedWheel wheel = loadWheel(side, pose, given, middle_m);
      for (std::size_t j = 0; j < wheel.count; ++j) {
        moment_Nm += wheel.patch[j].region.rolling_radius_m * wheel.patch[j].creep_x_N;
      }
    }
    (moment_Nm > 0.0 ? low_m : high_m) = middle_m;
  }
  return 0.5 * (low_m + high_m);
}

StandingWheelset WheelsetStand::compute(const StandingCase& given) const {
  const double arm_m = search_.geometry().tapingLine_m();
  std::array<double, 2> height_m{0.0, 0.0};
  double mean_radius_m = search_.geometry().wheelRadius_m();
  StandingWheelset standing;
  constexpr int kMostRounds = 30;
  constexpr double kNear_m = 1e-11;
  for (int round = 0; round < kMostRounds; ++round) {
    double moved_m = 0.0;
    for (std::size_t side = 0; side < kSides.size(); ++side) {
      std::array<double, 2> trial_m = height_m;
      const auto carries = [&](double height) {
        trial_m[side] = height;
        return computeVertical(kSides[side], poseOf(given, arm_m, trial_m), given, mean_radius_m) > given.load_N;
      };
      double low_m = kLowest_m, high_m = kHighest_m;
      if (!carries(low_m)) return standing;
      for (int i = 0; i < kHalvings; ++i) {
        const double middle_m = 0.5 * (low_m + high_m);
        (carries(middle_m) ? low_m : high_m) = middle_m;
      }
      moved_m = std::max(moved_m, std::abs(low_m - height_m[side]));
      height_m[side] = low_m;
    }
    standing.pose = poseOf(given, arm_m, height_m);
    if (round > 0 && moved_m < kNear_m) {
      standing.stands = true;
      break;
    }
    if (given.friction > 0.0) mean_radius_m = findMeanRadius(standing.pose, given);
  }
  for (const Side side : kSides) {
    standing.wheel[static_cast<std::size_t>(side)] = loadWheel(side, standing.pose, given, mean_radius_m);
  }
  return standing;
}

}  // namespace loco
