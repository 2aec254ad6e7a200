// The 3D locomotive's own energy account, term by term.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "loco_3d_fixtures.hpp"
#include "loco_dynamics/profile/contact_search.hpp"
#include "rail_core/testing/verification.hpp"

namespace {

using fixtures::Ride3d;
using loco::BodyLayout;
using loco::Loco3d;

Loco3d::Parameters onProfiles(std::shared_ptr<const rail::Track> track) {
  Loco3d::Parameters p = fixtures::paperParameters3d();
  static const auto finder = fixtures::finderOf(loco::ContactSearch(loco::WheelRailGeometry()));
  p.finder = finder;
  p.track = std::move(track);
  return p;
}

/// Energy of the contacts' springs as a function of the state, at the start of the last micro step.
double contactEnergy(const Ride3d& ride) {
  double sum_J = 0.0;
  for (std::size_t axle = 0; axle < BodyLayout::kAxles; ++axle) {
    const auto& contacts = ride.locomotive.contacts(axle);
    for (std::size_t i = 0; i < contacts.count; ++i)
      sum_J += 0.4 * contacts.list[i].elastic_N * contacts.list[i].region.approach_m;
  }
  return sum_J;
}

/// Energy of suspension and gravity at the ride's state.
double otherEnergy(const Ride3d& ride, const Loco3d::Parameters& p) {
  const loco::BodyState state = ride.bodies();
  loco::TrackFrames frames(ride.locomotive.dynamics().layout(), p.track.get());
  frames.place(state.q);
  frames.computeGaps(state.v);
  return ride.locomotive.dynamics().computeStoredEnergy(state, {&frames.gaps(), p.gravity_stiffness});
}

/// What pulls 490 kN against an equal coupler force for some seconds.
struct EnergyRide : Ride3d {
  EnergyRide(const Loco3d::Parameters& parameters, double v_mps) : Ride3d(parameters, v_mps, 3290.0), p(parameters) {
    force.traction_reference_N = 490e3;
    step();
    contacts_start_J = contactEnergy(*this);
    other_start_J = otherEnergy(*this, p);
    stored_start_J = sum.stored;
  }
  void pull(double seconds) {
    for (int i = 0; i < static_cast<int>(seconds / 0.002); ++i) {
      step();
      force.coupler_rear_N = -answer.traction_N;
      const double along_path_J = sum.stored - stored_start_J - (otherEnergy(*this, p) - other_start_J);
      const double difference_J = along_path_J - (contactEnergy(*this) - contacts_start_J);
      largest_difference_J = std::max(largest_difference_J, std::abs(difference_J));
    }
  }
  Loco3d::Parameters p;
  double contacts_start_J, other_start_J, stored_start_J;
  double largest_difference_J = 0.0;  ///< between the contacts' energy along their path and as a function of the state
};

TEST(Loco3dEnergyTest, OnStraightTrackTheFramesDoNoWork) {
  Loco3d::Parameters p = onProfiles(nullptr);
  p.gravity_stiffness = false;
  EnergyRide ride(p, 8.0);
  ride.pull(4.0);
  EXPECT_GT(ride.sum.motors, 1e7);
  rail::verify({"7", "3D on straight track: work of the frames' turning", "0", "J", 0.0, ride.sum.frames, 1e-9,
                "round-off of springs that hold 1 kJ, summed"});
}

/// Gravity's stiffness moves the points at which forces act, which is booked there, too: it comes and goes with the
/// bodies' pitch.
TEST(Loco3dEnergyTest, OnStraightTrackGravitysStiffnessWorksOnlyWhileBodiesPitch) {
  EnergyRide ride(onProfiles(nullptr), 8.0);
  ride.pull(2.0);
  const double pitched_J = ride.sum.frames;
  ride.pull(2.0);
  EXPECT_LT(std::abs(pitched_J), 1e-5 * ride.sum.motors);  // found 8.3 J of 6.8 MJ
  EXPECT_NEAR(ride.sum.frames, pitched_J, 0.05);
}

TEST(Loco3dEnergyTest, WhereTheContactsGeometryStaysTheirPathGivesTheEnergyOfTheState) {
  EnergyRide ride(onProfiles(nullptr), 8.0);
  ride.pull(4.0);
  rail::verify({"7", "3D on straight track: contacts' energy along the path", "0.4 N delta at the state", "J", 0.0,
                ride.largest_difference_J, 0.05,
                "of 0.1 J; found 0.02: contacts are read one micro step before the state"});
}

TEST(Loco3dEnergyTest, WhereTheContactsGeometryChangesTheirPathDiffersByLessThanTheyStore) {
  for (const double cant_mm : {0.0, 120.0}) {
    EnergyRide ride(onProfiles(fixtures::makeTrack("left", cant_mm)), 8.0);
    ride.pull(8.0);
    EXPECT_GT(ride.largest_difference_J, 5.0);  // or the test looks at nothing
    rail::verify(
        {"7",
         "3D into R300, cant " + std::to_string(static_cast<int>(cant_mm)) + " mm: contacts' energy along the path",
         "0.4 N delta at the state", "J", 0.0, ride.largest_difference_J, 25.0,
         "found 17 of 55 J: Hertz's stiffness changes along the profiles, which no force does work for"});
    EXPECT_LT(std::abs(ride.sum.residual()), 3e-7 * ride.sum.motors);
  }
}

TEST(Loco3dEnergyTest, InACantedCurveTheFramesWorkIsSmall) {
  EnergyRide ride(onProfiles(fixtures::makeTrack("left", 120.0)), 8.0);
  double largest_J = 0.0;
  for (int i = 0; i < 80; ++i) {
    ride.pull(0.1);
    largest_J = std::max(largest_J, std::abs(ride.sum.frames));
  }
  EXPECT_LT(largest_J, 2e-4 * ride.sum.motors);  // found 3.2 kJ of 26 MJ, 1.2e-4
}

}  // namespace
