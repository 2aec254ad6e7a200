#pragma once

#include "loco_dynamics/body_layout.hpp"
#include "loco_dynamics/track_frames.hpp"

namespace loco {

/// Adds what bodies feel because their frames follow a curved, canted track, v the body's speed along it:       (K1)
///   lateral  -m v^2 kappa cos(phi_c) - m g sin(phi_c)
///   vertical +m v^2 kappa sin(phi_c) + m g (1 - cos(phi_c))      (gravity itself, -m g, is with the suspension)
/// and a spinning wheelset's gyroscopic moments, H = J_spin omega:                                              (K2)
///   roll +H (psi' + v kappa),   yaw -H (phi' + v phi_c')
/// @param spin_inertia_kg_m2  J_spin of a wheelset; not the effective one that a geared motor makes
void addFrameForces(const BodyLayout& layout, const TrackFrames& frames, const BodyVector& v, double spin_inertia_kg_m2,
                    BodyVector& loads);

/// Adds what bodies feel because their frames turn faster or slower, as the change of the frame's momentum in a step:
/// (K3)
///   yaw -I_z d(v kappa)/dt,   roll -I_x d(v phi_c')/dt,   vertical -m d(v z_c')/dt,   lateral +m z d(v phi_c')/dt
/// with z the CoG's height. As a difference over the step it holds across a kink or a jump of the curvature, too.
void addTurningForces(const BodyLayout& layout, const TrackFrames& now, const TrackFrames& next,
                      const BodyVector& v_now, const BodyVector& v_next, double h, BodyVector& loads);

}  // namespace loco
