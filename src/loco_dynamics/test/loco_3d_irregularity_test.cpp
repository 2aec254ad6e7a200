// The 3D locomotive on rails that do not lie as designed.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <sstream>
#include <string>

#include "loco_3d_fixtures.hpp"
#include "rail_core/testing/verification.hpp"

namespace {

using fixtures::Ride3d;
using loco::BodyLayout;
using loco::Loco3d;
using loco::Side;
using loco::WheelsetContact;
using loco::WheelsetMotion;

constexpr double kMass_kg = 134000.0, kRadius_m = 0.5335, kStart_m = 3000.0;

struct Row {
  double lateral_mm = 0.0, vertical_mm = 0.0, cross_level_mm = 0.0, gauge_mm = 0.0;
};
using Shape = std::function<Row(double)>;  ///< over the distance from kStart_m

/// Straight and level, with rows every 0.5 m up to length_m.
std::shared_ptr<const rail::Track> trackWith(double length_m, const Shape& shape) {
  std::ostringstream text;
  text.precision(17);
  text << "name: uneven\nstart_km: 0\nend_km: 10\ngrades: [{from_km: 0, grade_permille: 0}]\ncurves: []\n"
          "speed_limits: [{from_km: 0, limit_kmph: 80}]\nirregularity: |\n"
          "  chainage_km,lateral_mm,vertical_mm,cross_level_mm,gauge_widening_mm\n";
  const int rows = static_cast<int>(2.0 * length_m);
  for (int i = 0; i <= rows; ++i) {
    const Row row = i == 0 || i == rows ? Row{} : shape(0.5 * i);
    text << "  " << 1e-3 * (kStart_m + 0.5 * i) << ',' << row.lateral_mm << ',' << row.vertical_mm << ','
         << row.cross_level_mm << ',' << row.gauge_mm << '\n';
  }
  rail::Problems problems;
  const rail::Document document = rail::Document::parse(text.str(), "track.yaml", problems);
  auto track = std::make_shared<const rail::Track>(rail::Track::read(rail::YamlReader(document, problems)));
  problems.throwIfAny();
  return track;
}

/// From 0 to 1 within the first and back within the last length_m of a stretch: (1 - cos)/2.
double window(double s_m, double whole_m, double length_m) {
  const double from_end_m = std::min(s_m, whole_m - s_m);
  return from_end_m < length_m ? 0.5 - 0.5 * std::cos(M_PI * from_end_m / length_m) : 1.0;
}

Loco3d::Parameters onTrack(std::shared_ptr<const rail::Track> track) {
  Loco3d::Parameters p = fixtures::paperParameters3d();
  p.track = std::move(track);
  return p;
}

double sumOfLoads(const loco::LocoTraction& answer) {
  double sum_N = 0.0;
  for (const loco::AxleAdhesion& axle : answer.adhesion.axles)
    sum_N += axle.vertical_force_N[0] + axle.vertical_force_N[1];
  return sum_N;
}

// --- one wheelset

WheelsetContact contact() {
  loco::RailConditions rail;
  rail.elsewhere = fixtures::readFile("/adhesion/paper_table1.yaml", loco::readCreepLaw);
  return {{kRadius_m, 100e3, {210e9, 0.28}, 82e9}, rail, fixtures::finderOf(fixtures::ConedWheel{})};
}

/// Pressed down by 0.1 mm, rolling at 10 m/s with 1 % of creep.
WheelsetMotion rolling() {
  WheelsetMotion motion;
  motion.q.setZero();
  motion.v.setZero();
  motion.q[loco::kZ] = -1e-4;
  motion.v[loco::kX] = 10.0;
  motion.v[loco::kPitch] = 10.1 / kRadius_m;
  return motion;
}

/// Every contact of two motions has the same forces, as far as the second is turned by small angles.
void expectSameForces(const WheelsetMotion& designed, const WheelsetMotion& moved, double tolerance_N) {
  WheelsetContact::Contacts a, b;
  contact().compute(designed, a);
  contact().compute(moved, b);
  ASSERT_EQ(a.count, 2u);
  ASSERT_EQ(b.count, 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    ASSERT_GT(a.list[i].normal_N, 10e3);
    EXPECT_NEAR(b.list[i].normal_N, a.list[i].normal_N, tolerance_N) << i;
    EXPECT_NEAR(b.list[i].creep_N.x(), a.list[i].creep_N.x(), tolerance_N) << i;
    EXPECT_NEAR(b.list[i].creep_N.y(), a.list[i].creep_N.y(), tolerance_N) << i;
  }
}

TEST(Loco3dIrregularityTest, AWheelsetThatIsMovedWithItsRailsFeelsTheSame) {
  WheelsetMotion moved = rolling();
  moved.irregular = true;
  moved.rails.left = moved.rails.right = {4e-3, -3e-3, 0.0, 0.0};
  moved.q[loco::kY] += 4e-3;
  moved.q[loco::kZ] -= 3e-3;
  expectSameForces(rolling(), moved, 1e-4);
}

TEST(Loco3dIrregularityTest, AWheelsetThatIsTurnedWithItsRailsFeelsTheSame) {
  WheelsetMotion turned = rolling();
  turned.irregular = true;
  turned.rails.left = turned.rails.right = {0.0, 0.0, 1e-3, 0.0};
  turned.q[loco::kYaw] = 1e-3;
  turned.v[loco::kY] = 1e-3 * turned.v[loco::kX];
  expectSameForces(rolling(), turned, 0.5);  // squares of 1e-3 of some 100 kN; without the turned yaw it is kilonewtons
}

TEST(Loco3dIrregularityTest, AWheelsetThatRisesWithItsRailsFeelsTheSame) {
  WheelsetMotion rising = rolling();
  rising.irregular = true;
  rising.rails.left = rising.rails.right = {0.0, 0.0, 0.0, 1e-3};
  rising.v[loco::kZ] = 1e-3 * rising.v[loco::kX];
  expectSameForces(rolling(), rising, 0.5);
  WheelsetContact::Contacts flat, slope;
  contact().compute(rolling(), flat);
  contact().compute(rising, slope);
  const double slope_N = slope.list[0].alongTrack_N() - flat.list[0].alongTrack_N();
  EXPECT_NEAR(slope_N, -1e-3 * std::cos(0.05) * flat.list[0].normal_N, 0.5);  // uphill it is held back
}

TEST(Loco3dIrregularityTest, ARailThatLiesHigherOrNearerIsFeltByItsWheelOnly) {
  for (const bool left : {true, false}) {
    WheelsetMotion motion = rolling();
    motion.irregular = true;
    (left ? motion.rails.left : motion.rails.right).z_m = 5e-5;
    WheelsetContact::Contacts contacts, designed;
    contact().compute(motion, contacts);
    contact().compute(rolling(), designed);
    const std::size_t here = left ? 0 : 1;
    EXPECT_GT(contacts.list[here].normal_N, 1.8 * designed.list[here].normal_N);  // 1.5^1.5
    EXPECT_EQ(contacts.list[1 - here].normal_N, designed.list[1 - here].normal_N);
  }
}

// --- the locomotive

TEST(Loco3dIrregularityTest, RailsAsDesignedAreToTheBitThoseOfATrackWithoutTheTable) {
  Ride3d without(onTrack(trackWith(60.0, [](double) { return Row{}; })), 10.0, 2900.0);  // has not reached it
  Ride3d with(onTrack(trackWith(60.0, [](double) { return Row{5.0, -3.0, 2.0, 1.0}; })), 10.0, 2900.0);
  for (int i = 0; i < 500; ++i) {
    without.step();
    with.step();
    ASSERT_TRUE(loco::samePayload(without.answer, with.answer)) << i;
  }
}

TEST(Loco3dIrregularityTest, ABumpInBothRailsLiftsEveryAxle) {
  const double whole_m = 120.0;
  Ride3d ride(onTrack(trackWith(whole_m,
                                [&](double s_m) {
                                  return Row{0.0, 5.0 * window(s_m, whole_m, 40.0)};
                                })),
              5.0, 2985.0);
  const loco::BodyState before = ride.bodies();
  ride.run(15.0);  // the CoG is at 3.06 km, on the plateau
  const loco::BodyState after = ride.bodies();
  for (std::size_t i = 0; i < BodyLayout::kBodies; ++i) {
    rail::verify({"13", "both rails 5 mm up: rise of body " + std::to_string(i), "exact", "mm", 5.0,
                  1e3 * (after.q[i][loco::kZ] - before.q[i][loco::kZ]), 0.01, "what is left of its bounce"});
    EXPECT_NEAR(after.q[i][loco::kY], 0.0, 1e-9) << i;
  }
}

/// The body above moves with the mean of the rails below its axles, so that the wheels carry m (g + z''):
/// for z = A sin(k s), whose wavelength is long against the bogies, m v^2 k^2 A.
TEST(Loco3dIrregularityTest, ALongWaveChangesTheWheelLoadsByMassTimesAcceleration) {
  constexpr double kWave_m = 200.0, kSpeed_mps = 25.0, kA_m = 0.02, k = 2.0 * M_PI / kWave_m;
  Ride3d ride(onTrack(trackWith(700.0,
                                [](double s_m) {
                                  return Row{0.0, 1e3 * kA_m * std::sin(k * s_m) * window(s_m, 700.0, 100.0)};
                                })),
              kSpeed_mps, 2990.0);
  ride.run(16.4);  // three periods: the CoG passes 3.4 km
  double in_phase_N = 0.0, out_of_phase_N = 0.0;
  const int steps = 4000;  // one wave
  for (int i = 0; i < steps; ++i) {
    ride.step();
    const double phase = k * (ride.answer.location_m - kStart_m);
    const double change_N = sumOfLoads(ride.answer) - fixtures::kWeight_N;
    in_phase_N += 2.0 / steps * change_N * std::sin(phase);
    out_of_phase_N += 2.0 / steps * change_N * std::cos(phase);
  }
  rail::verify({"13", "vertical wave, 200 m, 20 mm, 25 m/s: wheel loads in phase", "-m v^2 k^2 A", "kN",
                -1e-3 * kMass_kg * kSpeed_mps * kSpeed_mps * k * k * kA_m, 1e-3 * in_phase_N, 0.05,
                "2.5 %: mean over the axles takes 2 % away, bounce of 1 Hz at 0.125 Hz adds 1.5 %"});
  EXPECT_NEAR(out_of_phase_N, 0.0, 50.0);  // damping
}

TEST(Loco3dIrregularityTest, ASlowWaveOfTheAlignmentIsFollowedByTheWheelsets) {
  constexpr double kWave_m = 600.0, kA_m = 0.01, k = 2.0 * M_PI / kWave_m;
  const auto track =
      trackWith(900.0, [](double s_m) { return Row{1e3 * kA_m * std::sin(k * s_m) * window(s_m, 900.0, 150.0)}; });
  const Loco3d::Parameters parameters = onTrack(track);
  Ride3d ride(parameters, 20.0, 2985.0);
  ride.run(8.25);  // to 3.15 km
  double in_phase_m[BodyLayout::kAxles] = {};
  const int steps = 15000;  // one wave
  for (int i = 0; i < steps; ++i) {
    ride.step();
    const loco::BodyState bodies = ride.bodies();
    for (std::size_t axle = 0; axle < BodyLayout::kAxles; ++axle) {
      const auto& q = bodies.q[BodyLayout::wheelset(axle)];
      const double s_m = q[loco::kX] + parameters.structure.bodies[BodyLayout::wheelset(axle)].p_T.x();
      in_phase_m[axle] += 2.0 / steps * q[loco::kY] * std::sin(k * (s_m - kStart_m));
    }
  }
  for (std::size_t axle = 0; axle < BodyLayout::kAxles; ++axle) {
    rail::verify({"13", "alignment, 600 m, 10 mm: wheelset " + std::to_string(axle + 1) + " in phase", "it follows",
                  "mm", 1e3 * kA_m, 1e3 * in_phase_m[axle], 0.2,
                  "2 %: a bogie's own wave of 46 m adds 0.6 %, what the run-in left of it as much"});
  }
}

Row rough(double s_m) {
  const double w = window(s_m, 200.0, 20.0);
  return {3.0 * w * std::sin(0.7 * s_m), 2.0 * w * std::sin(0.9 * s_m + 1.0), 3.0 * w * std::sin(0.5 * s_m),
          2.0 * w * std::sin(0.3 * s_m)};
}

TEST(Loco3dIrregularityTest, MirroredRailsMirrorTheAnswer) {
  Ride3d ride(onTrack(trackWith(200.0, rough)), 10.0, 2985.0);
  Ride3d mirror(onTrack(trackWith(200.0,
                                  [](double s_m) {
                                    const Row row = rough(s_m);
                                    return Row{-row.lateral_mm, row.vertical_mm, -row.cross_level_mm, row.gauge_mm};
                                  })),
                10.0, 2985.0);
  for (Ride3d* each : {&ride, &mirror}) {
    each->force.traction_reference_N = 200e3;
    each->run(8.0);
  }
  const loco::BodyState a = ride.bodies(), b = mirror.bodies();
  double largest_m = 0.0;
  for (std::size_t i = 0; i < BodyLayout::kBodies; ++i) {
    largest_m = std::max(largest_m, std::abs(a.q[i][loco::kY]));
    for (const loco::Dof dof : {loco::kY, loco::kRoll, loco::kYaw}) EXPECT_NEAR(a.q[i][dof], -b.q[i][dof], 1e-10) << i;
    for (const loco::Dof dof : {loco::kX, loco::kZ}) EXPECT_NEAR(a.q[i][dof], b.q[i][dof], 1e-9) << i;
  }
  EXPECT_GT(largest_m, 1e-4);
}

TEST(Loco3dIrregularityTest, OnRoughRailsTheAccountClosesAndTheSpeedIsLtds) {
  Ride3d ride(onTrack(trackWith(200.0, rough)), 10.0, 2985.0);
  ride.force.traction_reference_N = 300e3;
  ride.run(10.0);
  EXPECT_GT(ride.sum.dampers, 1e3);  // the rails shake it
  rail::verify({"7", "3D on rough rails: residual over the motors' work", "exact", "1", 0.0,
                ride.sum.residual() / ride.sum.motors, 1e-5, "asked for; works use the mean of a step's speeds"});
  rail::verify({"7", "3D on rough rails: drift of the CoG against LTD", "exact", "m/s", 0.0,
                ride.answer.speed_mps - ride.ltd_speed, 1e-10, "round-off: the rails' slope is in the traction"});
}

/// What shakes it comes out of its speed, through the slope of the rails, and not from `frames`.
TEST(Loco3dIrregularityTest, RollingFreelyItPaysForItsShakingWithItsSpeed) {
  Loco3d::Parameters parameters = onTrack(trackWith(200.0, rough));
  parameters.gravity_stiffness = false;  // that turns forces with the bodies, which is work of the frames
  Ride3d ride(parameters, 10.0, 2985.0);
  ride.run(30.0);
  const double lost_J = ride.sum.dampers + ride.sum.slip + ride.sum.contact_damping;
  EXPECT_GT(ride.sum.dampers, 1e3);
  EXPECT_LT(ride.answer.speed_mps, 10.0);
  rail::verify({"7", "3D rolling over rough rails: kinetic energy lost over what the dampers, slip and contacts took",
                "exact", "1", 1.0, -(ride.sum.kinetic + ride.sum.stored) / lost_J, 1e-3, "the residual"});
  rail::verify({"7", "3D rolling over rough rails: work of the frames over that", "none", "1", 0.0,
                ride.sum.frames / lost_J, 1e-3, "turned parts of forces"});
}

TEST(Loco3dIrregularityTest, ARunMayStartOnThem) {
  Ride3d ride(onTrack(trackWith(200.0, rough)), 10.0, 3100.0);
  EXPECT_GT(std::abs(ride.bodies().q[BodyLayout::wheelset(0)][loco::kY]), 1e-6);
  ride.run(1.0);
  EXPECT_NEAR(sumOfLoads(ride.answer), fixtures::kWeight_N, 0.3 * fixtures::kWeight_N);
}

}  // namespace
