#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "loco_dynamics/adhesion_report.hpp"
#include "rail_core/sim_time.hpp"

namespace loco {

/// Version of the lock's protocol: meaning of the messages below. Both sides must have the same.
inline constexpr std::uint32_t kProtocolVersion = 3;

/// What LTD asks of and does to one locomotive during macro step k. Values at the start of the step, held over it.
/// Forces act on the locomotive, + forward.
struct LocoForce {
  std::uint64_t step = 0;
  rail::Nanoseconds step_length = 0;     ///< H [ns]
  double traction_reference_N = 0.0;     ///< after the motor response, before adhesion; < 0: dynamic brake
  double notch = 0.0;                    ///< of traction, 0 = idle
  double brake_notch = 0.0;              ///< of the dynamic brake, 0 = off
  double shoe_force_N = 0.0;             ///< largest retarding force of the brake shoes at all treads together, >= 0
  bool sanding = false;                  ///< sand is laid before the wheels
  double rim_power_limit_W = 0.0;        ///< that the notch allows at the rims
  double coupler_front_N = 0.0;          ///< > 0 in draft
  double coupler_rear_N = 0.0;           ///< < 0 in draft
  double propulsion_resistance_N = 0.0;  ///< Eq. (5), against the motion
  double curving_resistance_N = 0.0;     ///< Eq. (6), against the motion
  double grade_N = 0.0;                  ///< < 0 uphill
  double speed_mps = 0.0;                ///< of the vehicle in LTD
  double location_m = 0.0;               ///< chainage of the vehicle's CoG in LTD
};

/// A locomotive's answer to LocoForce of the same step.
struct LocoTraction {
  std::uint64_t step = 0;
  double traction_N = 0.0;   ///< mean over the step of the wheels' forces along the track, on the locomotive, + forward
  double speed_mps = 0.0;    ///< of the CoG along the track at the end of the step
  double location_m = 0.0;   ///< chainage of the CoG at the end of the step
  double work_rim_J = 0.0;   ///< of the motors' torques at the wheel rims during the step, < 0 when they brake
  double work_slip_J = 0.0;  ///< lost to slip between rim and rail during the step, >= 0
  double work_shoes_J = 0.0;  ///< turned into heat by the brake shoes during the step, >= 0 to 0.1 J
  std::vector<double> state;  ///< complete state at the end of the step
  AdhesionReport adhesion;    ///< at the end of the step
  std::string failure;        ///< empty, or why the model cannot go on: body, place, cause
};

/// True if both say the same, bit for bit.
bool samePayload(const LocoForce& a, const LocoForce& b);
bool samePayload(const LocoTraction& a, const LocoTraction& b);

/// True if every number is finite.
bool allFinite(const LocoForce& force);
bool allFinite(const LocoTraction& traction);

/// Digest of a payload, for comparing whole runs.
std::uint64_t payloadDigest(const LocoForce& force);
std::uint64_t payloadDigest(const LocoTraction& traction);

/// To which run, session and step a message belongs; see train_msgs/ExchangeId.
struct ExchangeId {
  std::uint64_t run_id = 0;
  std::uint32_t epoch = 0;
  std::uint32_t incarnation = 0;
  std::uint32_t locomotive = 0;  ///< from 1
};

struct ForceMessage {
  ExchangeId id;
  LocoForce force;
};

struct TractionMessage {
  enum class Kind { kAnswer, kNeedState, kFailed };
  ExchangeId id;
  Kind kind = Kind::kAnswer;
  LocoTraction traction;
};

struct JoinRequest {
  std::uint32_t protocol_version = kProtocolVersion;
  std::string build_id;
  std::uint64_t arithmetic_fingerprint = 0;
  std::uint32_t locomotive = 0;  ///< from 1
  std::string node;
};

struct JoinAnswer {
  bool accepted = false;
  std::string reason;  ///< why not
  bool wait = false;   ///< not accepted now, but asking again later makes sense
  ExchangeId id;
  std::uint64_t step = 0;     ///< the next step this locomotive will be asked for
  std::vector<double> state;  ///< at the start of that step; empty: equilibrium at location and speed
  double location_m = 0.0;
  double speed_mps = 0.0;
  rail::Nanoseconds step_length = 0;
  double heartbeat_deadline_s = 0.0;
  std::string configuration;   ///< resolved scenario
  std::string locomotive_key;  ///< dotted path of this locomotive's map in it
};

}  // namespace loco
