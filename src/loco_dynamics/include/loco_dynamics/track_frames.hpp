#pragma once

#include <array>
#include <optional>

#include "loco_dynamics/body_layout.hpp"
#include "loco_dynamics/suspension.hpp"
#include "rail_core/track.hpp"

namespace loco {

/// Frame T of one body: it follows the track at the body's arc length, x along the tangent, tilted by the cant about
/// the inner rail, origin midway between the rail tops.
struct TrackFrame {
  double s_m = 0.0;
  double curvature_1pm = 0.0;
  double roll_rad = 0.0;        ///< from cant, + left rail up
  double roll_slope_1pm = 0.0;  ///< d(roll)/ds
  double rise_m = 0.0;          ///< of the origin over the uncanted track
  double rise_slope = 0.0;
  bool irregular = false;   ///< a wheelset's: the rails below it may lie elsewhere
  rail::RailOffsets rails;  ///< then: where, in this frame; the frame itself follows the designed track
};

/// The track frames of all bodies of a locomotive. Copyable.
class TrackFrames {
 public:
  TrackFrames(const BodyLayout& layout, const rail::Track* track);

  /// Places the frames at the bodies' arc lengths. @param q  see BodyState: s = q.x + nominal place
  void place(const BodyVector& q);
  /// The gaps between frames of bodies that are joined, and their rates at these velocities.
  void computeGaps(const BodyVector& v);

  const TrackFrame& operator[](std::size_t body) const { return frames_[body]; }
  /// Heading of the track at this distance ahead of the car's place, against the car's frame [rad].
  double headingFromCar(double ahead_m) const;
  const FrameGaps& gaps() const { return gaps_; }

 private:
  void computeGap(std::size_t A, std::size_t B, const BodyVector& v);

  const rail::Track* track_;  ///< null: straight and level
  std::array<double, BodyLayout::kBodies> nominal_x_m_{};
  mutable std::array<std::size_t, BodyLayout::kBodies> hints_{};  ///< where a search begins; no part of the result
  std::array<TrackFrame, BodyLayout::kBodies> frames_{};
  FrameGaps gaps_{};
};

}  // namespace loco
