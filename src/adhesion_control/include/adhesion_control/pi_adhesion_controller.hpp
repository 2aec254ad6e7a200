#pragma once

#include "adhesion_control/adhesion_controller.hpp"
#include "adhesion_control/pi_controller.hpp"

namespace adhesion {

/// `law: pi`: one PiController for each axle, or one for each bogie.
///
/// A bogie's controller uses the slip of the axle that slips most, in the direction of the torque:             (A4)
///   s = max s_i in traction, min s_i in braking;  T_ref = the largest |T_ref,i|, with its sign
/// and takes the same R from all its axles (their references are equal unless the power limit (A8) lowers some), from
/// none more than its own T_ref,i. So an axle on bad rail costs the others of its bogie their torque.
///
/// Sampling: slip and reference are read, and I advances, every sampling period T_s; in between R is held, and   (A5)
///   T_i = T_ref,i - (R kept between 0 and T_ref,i)
/// in every micro step: a reference that falls is obeyed at once. The first micro step samples.
/// Not modelled: delay between sample and output, quantisation.
///
/// State: micro steps to the next sample; I of every group [N m]; R of every group [N m].
class PiAdhesionController : public AdhesionController {
 public:
  enum class Grouping { kAxle, kBogie };
  struct Parameters {
    PiController::Parameters pi;
    Grouping grouping = Grouping::kAxle;
    rail::Nanoseconds sampling_period = 0;  ///< T_s [ns], a whole multiple of the micro step; 0: every micro step
  };
  PiAdhesionController(const Parameters& parameters, const Setup& setup);

  std::size_t stateSize() const override { return 1 + 2 * groups_.size(); }
  void step(double v_mps, const std::vector<AxleMeasurement>& axles, double* state,
            std::vector<AxleCommand>& commands) const override;

 private:
  using Group = std::vector<std::size_t>;  ///< indices of the axles that share a controller
  double stepGroup(const Group& group, double v_mps, const std::vector<AxleMeasurement>& axles,
                   double& integral_N_m) const;

  PiController pi_;
  double wheel_radius_m_;
  std::vector<Group> groups_;
  double steps_per_sample_;  ///< a whole number
  double period_s_;          ///< T_s
};

}  // namespace adhesion
