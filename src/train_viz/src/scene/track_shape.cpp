#include "train_viz/track_shape.hpp"

#include <cmath>
#include <cstdio>

#include "rail_core/constants.hpp"

namespace viz {

namespace {

constexpr double kChordTolerance_m = 0.002;  // chosen: less than a contact is long
constexpr double kSpacing_m = 1.0;           // chosen: of the places looked at; in R50 the chord is 2.5 mm off
constexpr int kMostSpacings = 100;           // chosen: keeps the search short, and long straights in pieces

constexpr double kBedHalfWidth_m = 1.7;  // chosen: about a ballast bed's
constexpr double kBedDepth_m = 0.2;      // chosen: below the rail tops; a rail is 0.172 m high (UIC60)
constexpr Colour kBed{0.36, 0.34, 0.32, 1.0};

constexpr double kPostSpacing_m = 100.0;
constexpr double kLongLine_m = 30.0e3;  // chosen: on a longer one only every km has a post
constexpr double kNearLetters_m = 2.0;  // chosen: read from where one looks at a few vehicles
constexpr double kNearOffset_m = 4.5;
constexpr double kFarLetters_m = 45.0;  // chosen: read from above a train of 1.6 km; so high that near views miss it
constexpr double kFarOffset_m = 70.0;
constexpr double kFarHeight_m = 150.0;

Eigen::Vector3d positionOf(const rail::TrackPose& pose) { return {pose.x_m, pose.y_m, pose.z_m}; }

/// Largest distance of the places strictly between i and j from the chord.
double deviation(const std::vector<Eigen::Vector3d>& places, std::size_t i, std::size_t j) {
  const Eigen::Vector3d along = (places[j] - places[i]).normalized();
  double largest_m = 0.0;
  for (std::size_t k = i + 1; k < j; ++k) {
    const Eigen::Vector3d d = places[k] - places[i];
    largest_m = std::max(largest_m, (d - d.dot(along) * along).norm());
  }
  return largest_m;
}

Caption makePost(const rail::WorldTrack& world, double s_m, bool far) {
  const Eigen::Vector3d near_place(0.0, -kNearOffset_m, 0.5 * kNearLetters_m),
      far_place(0.0, -kFarOffset_m, kFarHeight_m);
  char text[32];
  std::snprintf(text, sizeof text, far ? "%.0f km" : "%.1f", s_m / rail::kMetresPerKilometre);
  return {frameOf(world.at(s_m)) * (far ? far_place : near_place), far ? kFarLetters_m : kNearLetters_m, text};
}

std::vector<Caption> makePosts(const rail::Track& track, const rail::WorldTrack& world) {
  const bool is_long = track.end_m() - track.start_m() > kLongLine_m;
  const long per_km = std::lround(rail::kMetresPerKilometre / kPostSpacing_m);
  std::vector<Caption> posts;
  for (auto i = static_cast<long>(std::ceil(track.start_m() / kPostSpacing_m));
       static_cast<double>(i) * kPostSpacing_m <= track.end_m(); ++i) {
    const double s_m = static_cast<double>(i) * kPostSpacing_m;
    if (!is_long || i % per_km == 0) posts.push_back(makePost(world, s_m, false));
    if (i % per_km == 0) posts.push_back(makePost(world, s_m, true));
  }
  return posts;
}

}  // namespace

std::vector<double> computeChords(const rail::Track& track, const rail::WorldTrack& world, double tolerance_m) {
  std::vector<double> s_m;
  std::vector<Eigen::Vector3d> places;
  for (double s = track.start_m(); s < track.end_m(); s += kSpacing_m) s_m.push_back(s);
  s_m.push_back(track.end_m());
  for (const double s : s_m) places.push_back(positionOf(world.at(s)));
  std::vector<double> chords = {s_m.front()};
  std::size_t last = 0;
  for (std::size_t i = 1; i + 1 < places.size(); ++i) {
    if (i + 1 - last <= kMostSpacings && deviation(places, last, i + 1) <= tolerance_m) continue;
    chords.push_back(s_m[i]);
    last = i;
  }
  chords.push_back(s_m.back());
  return chords;
}

TrackShape computeTrackShape(const rail::Track& track, const rail::WorldTrack& world) {
  TrackShape shape;
  Eigen::Vector3d left_before = Eigen::Vector3d::Zero(), right_before = Eigen::Vector3d::Zero();
  for (const double s_m : computeChords(track, world, kChordTolerance_m)) {
    const Eigen::Isometry3d X_WT = frameOf(world.at(s_m));
    const double half_m = 0.5 * rail::kCantBaseline_m;
    const Eigen::Vector3d left = X_WT * Eigen::Vector3d(0.0, kBedHalfWidth_m, -kBedDepth_m);
    const Eigen::Vector3d right = X_WT * Eigen::Vector3d(0.0, -kBedHalfWidth_m, -kBedDepth_m);
    if (!shape.centre.empty()) shape.bed.add(right_before, right, left, left_before, kBed);
    shape.left_rail.push_back(X_WT * Eigen::Vector3d(0.0, half_m, 0.0));
    shape.right_rail.push_back(X_WT * Eigen::Vector3d(0.0, -half_m, 0.0));
    shape.centre.push_back(X_WT * Eigen::Vector3d(0.0, 0.0, -0.5 * kBedDepth_m));
    left_before = left;
    right_before = right;
  }
  shape.posts = makePosts(track, world);
  return shape;
}

}  // namespace viz
