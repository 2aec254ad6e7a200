#include "loco_dynamics/frame_forces.hpp"

#include <cmath>

#include "rail_core/constants.hpp"

namespace loco {

void addFrameForces(const BodyLayout& layout, const TrackFrames& frames, const BodyVector& v, double spin_inertia_kg_m2,
                    BodyVector& loads) {
  for (std::size_t i = 0; i < BodyLayout::kBodies; ++i) {
    const TrackFrame& frame = frames[i];
    const double m = layout.bodies()[i].mass_kg, v_x = v[i][kX];
    const double turning = v_x * frame.curvature_1pm;
    const double centrifugal_N = m * v_x * turning, weight_N = m * rail::kGravity_mps2;
    const double sin = std::sin(frame.roll_rad), cos = std::cos(frame.roll_rad);
    loads[i][kY] -= centrifugal_N * cos + weight_N * sin;  // (K1)
    loads[i][kZ] += centrifugal_N * sin + weight_N * (1.0 - cos);
    if (i < BodyLayout::wheelset(0)) continue;
    const double H = spin_inertia_kg_m2 * v[i][kPitch];
    loads[i][kRoll] += H * (v[i][kYaw] + turning);  // (K2)
    loads[i][kYaw] -= H * (v[i][kRoll] + v_x * frame.roll_slope_1pm);
  }
}

void addTurningForces(const BodyLayout& layout, const TrackFrames& now, const TrackFrames& next,
                      const BodyVector& v_now, const BodyVector& v_next, double h, BodyVector& loads) {
  for (std::size_t i = 0; i < BodyLayout::kBodies; ++i) {
    const Body& body = layout.bodies()[i];
    const double v_old = v_now[i][kX], v_new = v_next[i][kX];
    const double yaw_rate = (v_new * next[i].curvature_1pm - v_old * now[i].curvature_1pm) / h;
    const double roll_rate = (v_new * next[i].roll_slope_1pm - v_old * now[i].roll_slope_1pm) / h;
    const double rise_rate = (v_new * next[i].rise_slope - v_old * now[i].rise_slope) / h;
    loads[i][kYaw] -= body.inertia_kg_m2.z() * yaw_rate;  // (K3)
    loads[i][kRoll] -= body.inertia_kg_m2.x() * roll_rate;
    loads[i][kZ] -= body.mass_kg * rise_rate;
    loads[i][kY] += body.mass_kg * body.p_T.z() * roll_rate;
  }
}

}  // namespace loco
