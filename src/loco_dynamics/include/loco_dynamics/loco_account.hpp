#pragma once

namespace loco {

/// Energies of a locomotive with bodies in the last macro step [J]:
///   motors + outer + frames = d(kinetic) + d(stored) + dampers + slip + shoes + contact_damping + residual
struct LocoAccount {
  double motors = 0.0;           ///< torque times spin of the wheelset against its frame
  double outer = 0.0;            ///< work of couplers, resistances and grade
  double frames = 0.0;           ///< work by the turning of the track frames; 0 in 2D, which knows no curves
  double dampers = 0.0;          ///< in the suspension
  double slip = 0.0;             ///< between wheel and rail
  double shoes = 0.0;            ///< brake shoes
  double contact_damping = 0.0;  ///< in the normal contact
  double kinetic = 0.0;          ///< change of, against the track frames
  double stored = 0.0;           ///< change of: suspension, gravity, contacts
  double residual() const {
    return motors + outer + frames - kinetic - stored - dampers - slip - shoes - contact_damping;
  }
};

}  // namespace loco
