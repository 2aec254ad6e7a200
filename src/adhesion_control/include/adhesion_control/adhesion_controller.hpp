#pragma once

#include <cstddef>
#include <vector>

#include "rail_core/sim_time.hpp"

namespace adhesion {

/// What a controller knows of its locomotive. Constant.
struct Setup {
  rail::Nanoseconds micro_step = 0;        ///< h [ns], > 0: time between two calls of step()
  double wheel_radius_m = 0.0;             ///< r, nominal
  std::vector<std::size_t> bogie_of_axle;  ///< for every axle from the front the bogie that it is in, both from 0

  std::size_t axles() const { return bogie_of_axle.size(); }
};

/// What a controller is told of one axle at the start of a micro step. Torques act on the wheelset, + driving forward.
struct AxleMeasurement {
  double omega_radps = 0.0;           ///< spin of the wheelset, + rolling forward
  double torque_reference_N_m = 0.0;  ///< T_ref after the limits (A7), (A8): > 0 traction, < 0 braking
};

/// What a controller answers for one axle.
struct AxleCommand {
  double torque_N_m = 0.0;  ///< T on the wheelset, held over the micro step
  bool active = false;      ///< the controller is taking torque away
};

/// An adhesion controller of one locomotive: what a controller of your own implements. docs/adhesion_control.md has a
/// complete example.
///
/// A controller is a pure function (measurements, state) -> (torques, state). The object holds constants only; all that
/// it remembers (integrators, filters, timers) is in `state`, which the caller owns, sends in messages and may hand to
/// another object with the same parameters, in another process, at any step: it must go on with the same bits. So
/// use no clock, no random numbers without their state, no members that change.
class AdhesionController {
 public:
  virtual ~AdhesionController() = default;

  /// Number of doubles in the state; may be 0.
  virtual std::size_t stateSize() const = 0;

  /// State of a locomotive that rolls freely, without torque; every number finite.
  virtual std::vector<double> initialState() const { return std::vector<double>(stateSize(), 0.0); }

  /// Called once at the start of every micro step. Must not throw, allocate, lock, log or read parameters.
  /// @param v_mps  speed of the train along the track, + forward
  /// @param axles  one entry for each axle from the front
  /// @param state  stateSize() doubles at the start of the micro step; becomes the state at its end
  /// @param commands  as many entries as `axles`; every one is overwritten
  virtual void step(double v_mps, const std::vector<AxleMeasurement>& axles, double* state,
                    std::vector<AxleCommand>& commands) const = 0;
};

}  // namespace adhesion
