#include "rail_core/world_track.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

constexpr double kPi = 3.14159265358979323846;

rail::Track makeTrack(const std::string& curves, const std::string& grade = "0") {
  rail::Problems problems;
  const rail::Document document =
      rail::Document::parse("{name: t, start_km: 1, end_km: 3, grades: [{from_km: 1, grade_permille: " + grade +
                                "}], curves: [" + curves + "], speed_limits: [{from_km: 1, limit_kmph: 80}]}",
                            "track.yaml", problems);
  rail::Track track = rail::Track::read(rail::YamlReader(document, problems));
  problems.throwIfAny();
  return track;
}

TEST(WorldTrackTest, StraightTrackRunsAlongXFromItsStartAndBeyondItsEnds) {
  const rail::Track track = makeTrack("");
  const rail::WorldTrack world(track);
  for (const double s_m : {980.0, 1000.0, 1234.5, 3000.0, 3050.0}) {
    const rail::TrackPose pose = world.at(s_m);
    EXPECT_NEAR(pose.x_m, s_m - 1000.0, 1e-9);
    EXPECT_EQ(pose.y_m, 0.0);
    EXPECT_EQ(pose.heading_rad, 0.0);
  }
}

TEST(WorldTrackTest, QuarterCircleToTheLeftEndsAtItsRadiusAheadAndToTheLeft) {
  const double length_m = 50.0 * kPi / 2.0;  // R = 50 m, the tightest there is
  const rail::Track track = makeTrack(
      "{start_km: 1.1, radius_m: 50, direction: left, transition_in_m: 0, circular_m: " + std::to_string(length_m) +
      ", transition_out_m: 0, cant_mm: 0}");
  const rail::TrackPose pose = rail::WorldTrack(track).at(1100.0 + length_m);
  EXPECT_NEAR(pose.x_m, 150.0, 1e-5);  // length given to 1e-6 m; a node's interval straddles the curve's begin
  EXPECT_NEAR(pose.y_m, 50.0, 1e-5);
  EXPECT_NEAR(pose.heading_rad, kPi / 2.0, 1e-7);
}

TEST(WorldTrackTest, ClothoidMeetsItsSeries) {
  const double L = 100.0, R = 300.0;
  const rail::Track track = makeTrack(
      "{start_km: 1.5, radius_m: 300, direction: right, transition_in_m: 100, circular_m: 50, transition_out_m: 0, "
      "cant_mm: 0}");
  const rail::TrackPose pose = rail::WorldTrack(track).at(1600.0);
  const double t = L / (2.0 * R);  // heading at the end; x = L (1 - t^2/10 + t^4/216), y = L (t/3 - t^3/42 + t^5/1320)
  EXPECT_NEAR(pose.x_m, 500.0 + L * (1.0 - t * t / 10.0 + t * t * t * t / 216.0), 1e-6);
  EXPECT_NEAR(pose.y_m, -L * (t / 3.0 - t * t * t / 42.0 + t * t * t * t * t / 1320.0), 1e-6);
  EXPECT_NEAR(pose.heading_rad, -t, 1e-12);
}

TEST(WorldTrackTest, RisesWithTheGradeAndRollsWithTheCant) {
  const rail::Track track = makeTrack(
      "{start_km: 1.5, radius_m: 600, direction: left, transition_in_m: 50, circular_m: 100, transition_out_m: 50, "
      "cant_mm: 150}",
      "20");
  const rail::TrackPose pose = rail::WorldTrack(track).at(1600.0);
  EXPECT_NEAR(pose.z_m, 12.0, 1e-9);
  EXPECT_NEAR(pose.pitch_rad, -0.02, 1e-5);
  EXPECT_NEAR(pose.roll_rad, -0.1, 2e-4);  // the outer rail is the right one: it stands 150 mm higher
}

}  // namespace
