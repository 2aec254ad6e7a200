#include "loco_dynamics/track_frames.hpp"

#include <cmath>

namespace loco {

TrackFrames::TrackFrames(const BodyLayout& layout, const rail::Track* track) : track_(track) {
  for (std::size_t i = 0; i < BodyLayout::kBodies; ++i) nominal_x_m_[i] = layout.bodies()[i].p_T.x();
  const double car_z_m = layout.bodies()[BodyLayout::kCar].p_T.z();
  for (std::size_t i = 0; i < BodyLayout::kBogies; ++i)
    gaps_[gapIndex(BodyLayout::kCar, BodyLayout::bogie(i))].cog_height_A_m = car_z_m;
  for (std::size_t axle = 0; axle < BodyLayout::kAxles; ++axle) {
    const std::size_t set = BodyLayout::wheelset(axle);
    gaps_[gapIndex(set, BodyLayout::bogieOfAxle(axle))].cog_height_A_m = layout.bodies()[set].p_T.z();
  }
}

void TrackFrames::place(const BodyVector& q) {
  for (std::size_t i = 0; i < BodyLayout::kBodies; ++i) {
    TrackFrame& frame = frames_[i];
    frame.s_m = q[i][kX] + nominal_x_m_[i];
    if (track_ == nullptr) continue;
    frame.curvature_1pm = track_->at(frame.s_m, hints_[i]).curvature_1pm;
    frame.irregular = i >= BodyLayout::wheelset(0) && track_->irregularity().covers(frame.s_m);
    if (frame.irregular) frame.rails = track_->irregularity().at(frame.s_m);
    if (!track_->canted()) continue;
    const rail::TrackCant cant = track_->cant(frame.s_m, rail::kCantWindow_m, hints_[i]);
    frame.roll_rad = cant.computeRoll_rad();
    frame.roll_slope_1pm = cant.computeRollSlope_1pm();
    frame.rise_m = 0.5 * cant.outer_m;  // it turns about the inner rail
    frame.rise_slope = 0.5 * cant.outer_slope;
  }
}

double TrackFrames::headingFromCar(double ahead_m) const {
  if (track_ == nullptr) return 0.0;
  const double s_m = frames_[BodyLayout::kCar].s_m;
  return track_->stretch(s_m, s_m + ahead_m, hints_[BodyLayout::kCar]).heading_rad;
}

void TrackFrames::computeGaps(const BodyVector& v) {
  if (track_ == nullptr) return;
  for (std::size_t i = 0; i < BodyLayout::kBogies; ++i) computeGap(BodyLayout::kCar, BodyLayout::bogie(i), v);
  for (std::size_t axle = 0; axle < BodyLayout::kAxles; ++axle)
    computeGap(BodyLayout::wheelset(axle), BodyLayout::bogieOfAxle(axle), v);
}

void TrackFrames::computeGap(std::size_t A, std::size_t B, const BodyVector& v) {
  const TrackFrame &a = frames_[A], &b = frames_[B];
  FrameGap& gap = gaps_[gapIndex(A, B)];
  const rail::TrackStretch stretch = track_->stretch(b.s_m, a.s_m, hints_[B]);
  gap.at = {stretch.heading_rad, stretch.lateral_m, a.roll_rad - b.roll_rad, a.rise_m - b.rise_m};
  const double v_A = v[A][kX], v_B = v[B][kX];
  gap.rate.heading_rad = a.curvature_1pm * v_A - b.curvature_1pm * v_B;
  gap.rate.lateral_m = v_A * stretch.heading_rad - v_B * b.curvature_1pm * (a.s_m - b.s_m);
  gap.rate.roll_rad = a.roll_slope_1pm * v_A - b.roll_slope_1pm * v_B;
  gap.rate.height_m = a.rise_slope * v_A - b.rise_slope * v_B;
}

}  // namespace loco
