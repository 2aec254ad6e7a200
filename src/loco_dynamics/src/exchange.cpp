#include "loco_dynamics/exchange.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "rail_core/digest.hpp"

namespace loco {

namespace {

// The numbers of a message in the order of its fields: the one list that comparison, check and digest go through.
std::array<double, 13> numbersOf(const LocoForce& f) {
  return {f.traction_reference_N,
          f.notch,
          f.brake_notch,
          f.shoe_force_N,
          f.sanding ? 1.0 : 0.0,
          f.rim_power_limit_W,
          f.coupler_front_N,
          f.coupler_rear_N,
          f.propulsion_resistance_N,
          f.curving_resistance_N,
          f.grade_N,
          f.speed_mps,
          f.location_m};
}

std::array<double, 6> numbersOf(const LocoTraction& t) {
  return {t.traction_N, t.speed_mps, t.location_m, t.work_rim_J, t.work_slip_J, t.work_shoes_J};
}

template <typename Numbers>
bool finite(const Numbers& numbers) {
  return std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); });
}

}  // namespace

std::uint64_t payloadDigest(const LocoForce& force) {
  rail::Digest digest;
  digest.add(force.step);
  digest.add(static_cast<std::uint64_t>(force.step_length));
  for (const double x : numbersOf(force)) digest.add(x);
  return digest.value();
}

std::uint64_t payloadDigest(const LocoTraction& traction) {
  rail::Digest digest;
  digest.add(traction.step);
  for (const double x : numbersOf(traction)) digest.add(x);
  digest.add(traction.state);
  addTo(digest, traction.adhesion);
  return digest.value();
}

bool samePayload(const LocoForce& a, const LocoForce& b) { return payloadDigest(a) == payloadDigest(b); }

bool samePayload(const LocoTraction& a, const LocoTraction& b) {
  return payloadDigest(a) == payloadDigest(b) && a.failure == b.failure;
}

bool allFinite(const LocoForce& force) { return finite(numbersOf(force)); }

bool allFinite(const LocoTraction& traction) {
  return finite(numbersOf(traction)) && finite(traction.state) && allFinite(traction.adhesion);
}

}  // namespace loco
