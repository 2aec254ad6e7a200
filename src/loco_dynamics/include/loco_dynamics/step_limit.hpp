#pragma once

#include <limits>
#include <string>

#include "loco_dynamics/linear_model.hpp"

namespace loco {

/// Share of the longest stable step that a scenario may use.
/// Chosen: near its limit semi-implicit Euler runs but is wrong (1.85 ms for the paper's locomotive, whose linear limit
/// is 1.84 ms). A wheel's frequency rises as N^(1/6), so this share is good for wheel loads up to 3.3 times the static.
inline constexpr double kStepShare = 0.82;

/// What bounds the micro step of a locomotive.
struct StepLimit {
  double stable_s = std::numeric_limits<double>::infinity();  ///< longest step with which nothing grows
  double frequency_Hz = 0.0;                                  ///< of the motion that grows beyond it, undamped
  double damping = 0.0;                                       ///< its damping ratio
  std::string mode;                                           ///< its name
  double largest_s() const { return kStepShare * stable_s; }
};

/// Largest factor by which a motion grows in one step of semi-implicit Euler, (I1) with (S2) implicit; 1 is neutral.
/// (L3)
double computeSpectralRadius(const LinearModel& model, double step_s);

/// By bisection of the spectral radius, to 1e-4 of itself. @param model  with at least one spring
StepLimit computeStepLimit(const LinearModel& model);

}  // namespace loco
