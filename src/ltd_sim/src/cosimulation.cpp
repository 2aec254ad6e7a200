#include "ltd_sim/cosimulation.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdio>
#include <exception>
#include <utility>

#include "rail_core/constants.hpp"
#include "rail_core/digest.hpp"

namespace ltd {

namespace {

std::string kilometres(double s_m) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3f km", s_m / rail::kMetresPerKilometre);
  return text;
}

std::string nameOf(std::size_t loco) { return "loco_" + std::to_string(loco + 1); }

void mixIn(std::uint64_t& digest, std::uint64_t payload) {
  rail::Digest sum;
  sum.add(digest);
  sum.add(payload);
  digest = sum.value();
}

}  // namespace

Cosimulation::Cosimulation(const Scenario& scenario, std::vector<loco::LocoPort*> ports,
                           std::vector<RunObserver*> observers, DriverPort* driver)
    : scenario_(scenario),
      ports_(std::move(ports)),
      observers_(std::move(observers)),
      driver_port_(driver),
      dynamics_(scenario.train, scenario.track, scenario.driver, scenario.air_brake, scenario.macro_step),
      state_(dynamics_.initialState(scenario.run.start_location_m, scenario.run.start_speed_mps)),
      loco_forces_(ports_.size()),
      answers_(ports_.size(), nullptr) {
  assert(ports_.size() == scenario.train.locomotives.size());
  assert(!scenario.driver.external() || driver != nullptr);
  dynamics_.updateStoredEnergies(state_);
}

void Cosimulation::start() {
  guarded([this] {
    for (RunObserver* observer : observers_) observer->onStart(state_);
  });
}

void Cosimulation::begin() {
  assert(!under_way_ && !outcome_.ended());
  under_way_ = true;
  dynamics_.computeOuterForces(state_, forces_);
  asks_driver_ = scenario_.driver.asksAt(time()) && silence_.empty();
  if (asks_driver_)
    driver_port_->ask(state_.step, forces_.view);
  else
    sendForces();
}

void Cosimulation::sendForces() {
  dynamics_.decide(state_, forces_);
  for (std::size_t i = 0; i < ports_.size(); ++i) {
    dynamics_.fillLocoForce(i, state_, forces_, loco_forces_[i]);
    ports_[i]->send(loco_forces_[i], state_.loco_state[i]);
  }
}

/// @return true once it is known what the driver wants, or that he is silent
bool Cosimulation::takeCommand() {
  if (const DriverCommand* command = driver_port_->answer()) {
    std::string fault = scenario_.driver.give(*command, state_.driver);
    if (fault.empty()) fault = scenario_.air_brake.refuse(*command);
    if (fault.empty()) return true;
    driver_port_->refuse(fault);
  }
  if (!driver_port_->silent()) return false;
  char text[160];
  std::snprintf(text, sizeof text, "driver: no answer within %g s to the question of %.3f s at %s: the train brakes",
                driver_port_->deadline_s(), rail::toSeconds(time()), kilometres(leadingLocation()).c_str());
  silence_ = text;
  scenario_.driver.giveSilence(state_.driver);
  return true;
}

bool Cosimulation::gatherAnswers() {
  for (std::size_t i = 0; i < ports_.size(); ++i) {
    answers_[i] = ports_[i]->answer();
    if (answers_[i] == nullptr) return false;
  }
  return true;
}

bool Cosimulation::tryCommit() {
  if (!under_way_) return false;
  if (asks_driver_) {
    if (!takeCommand()) return false;
    asks_driver_ = false;
    sendForces();
  }
  if (!gatherAnswers()) return false;
  before_ = state_;
  std::string fault = modelFailure();  // first: of an answer that failed nothing else holds
  state_.limit_watch.look(forces_.view);
  if (fault.empty()) fault = dynamics_.step(state_, forces_, answers_);
  if (fault.empty()) fault = checkSpeeds();
  if (!fault.empty()) {
    state_ = before_;
    end(Outcome::Kind::kFailed,
        fault + " in step " + std::to_string(state_.step) + " at " + kilometres(locationOfFault()));
    return true;
  }
  for (std::size_t i = 0; i < ports_.size(); ++i) {
    mixIn(outcome_.exchange_digest, loco::payloadDigest(loco_forces_[i]));
    mixIn(outcome_.exchange_digest, loco::payloadDigest(*answers_[i]));
  }
  if (time() % scenario_.output.telemetry_interval == 0 || time() % scenario_.output.timeseries_interval == 0)
    dynamics_.updateStoredEnergies(state_);
  const StepRecord record{before_, state_, forces_, loco_forces_, answers_};
  under_way_ = false;
  guarded([&] {
    for (RunObserver* observer : observers_) observer->onStep(record);
  });
  if (!outcome_.ended()) checkEnd();
  return true;
}

std::string Cosimulation::modelFailure() const {
  for (std::size_t i = 0; i < answers_.size(); ++i) {
    if (!answers_[i]->failure.empty()) return nameOf(i) + ": " + answers_[i]->failure;
  }
  return {};
}

/// That of the first locomotive that failed, or the leading one's.
double Cosimulation::locationOfFault() const {
  for (std::size_t i = 0; i < answers_.size(); ++i)
    if (!answers_[i]->failure.empty()) return state_.s_m[scenario_.train.locomotives[i].vehicle];
  return leadingLocation();
}

std::string Cosimulation::checkSpeeds() {
  for (std::size_t i = 0; i < answers_.size(); ++i) {
    const double drift = std::abs(answers_[i]->speed_mps - state_.v_mps[scenario_.train.locomotives[i].vehicle]);
    largest_drift_mps_ = std::max(largest_drift_mps_, drift);
    if (!(drift <= scenario_.lock.synchronisation_tolerance_mps)) {
      char text[160];
      std::snprintf(text, sizeof text,
                    "%s: its speed differs from LTD's by %.3g m/s (lock.synchronisation_tolerance_mps %.3g)",
                    nameOf(i).c_str(), drift, scenario_.lock.synchronisation_tolerance_mps);
      return text;
    }
  }
  return {};
}

void Cosimulation::checkEnd() {
  const int off = dynamics_.vehicleOffTrack(state_);
  if (leadingLocation() >= scenario_.run.end_location_m) {
    end(Outcome::Kind::kFinished, "reached " + kilometres(scenario_.run.end_location_m));
  } else if (off >= 0) {
    end(Outcome::Kind::kFailed, "vehicle " + std::to_string(off + 1) + " left the track at " +
                                    kilometres(state_.s_m[static_cast<std::size_t>(off)]));
  } else if (time() >= scenario_.run.end_time) {
    char text[48];
    std::snprintf(text, sizeof text, "reached the end time %g s", rail::toSeconds(scenario_.run.end_time));
    end(Outcome::Kind::kFinished, text);
  } else if (const std::string fault = runaway(); !fault.empty()) {
    end(Outcome::Kind::kFailed, fault);
  } else if (stands()) {
    if (silence_.empty())
      end(Outcome::Kind::kFinished, "stands at " + kilometres(leadingLocation()));
    else
      end(Outcome::Kind::kFailed, silence_ + ", and stands at " + kilometres(leadingLocation()));
  } else if (stalled()) {
    end(Outcome::Kind::kFailed, "stalled at " + kilometres(leadingLocation()) +
                                    ": traction on, and slower than stall.speed_below_mps for stall.for_s");
  }
}

bool Cosimulation::stalled() {
  const bool pulling = std::any_of(forces_.notch.begin(), forces_.notch.end(), [](int n) { return n > 0; });
  if (!pulling || std::abs(leadingSpeed()) >= scenario_.run.stall_speed_mps) {
    state_.slow_since = -1;
    return false;
  }
  if (state_.slow_since < 0) state_.slow_since = time();
  return time() - state_.slow_since >= scenario_.run.stall_time;
}

/// At rest for so long, after having moved, that the run ends: for run.end_at_standstill_s or, if the driver is silent,
/// for a second.
bool Cosimulation::stands() {
  constexpr double kMoving_mps = 0.1, kResting_mps = 0.005;  // chosen: a locomotive's wheels creep on a grade
  const double v = std::abs(leadingSpeed());
  state_.moved = state_.moved || v > kMoving_mps;
  if (!state_.moved || v > kResting_mps) {
    state_.standing_since = -1;
    return false;
  }
  if (state_.standing_since < 0) state_.standing_since = time();
  const rail::Nanoseconds asked = scenario_.run.standstill_time;
  if (asked == 0 && silence_.empty()) return false;
  return time() - state_.standing_since >= (asked > 0 ? asked : rail::kNanosecondsPerSecond);
}

std::string Cosimulation::runaway() const {
  const double limit_mps = forces_.view.speed_limit_mps;
  if (leadingSpeed() <= limit_mps + scenario_.run.runaway_margin_mps) return {};
  char text[160];
  std::snprintf(
      text, sizeof text, "runaway at %s: %.1f km/h where %.1f are allowed, beyond run.runaway_above_limit_kmph",
      kilometres(leadingLocation()).c_str(), leadingSpeed() * rail::kKmphPerMps, limit_mps * rail::kKmphPerMps);
  return text;
}

std::vector<std::string> Cosimulation::notes() const {
  std::vector<std::string> told = scenario_.driver.notes(state_.driver);
  if (!silence_.empty()) told.push_back(silence_);
  if (state_.limit_watch.times > 0) told.push_back(state_.limit_watch.note());
  for (std::size_t i = 0; i < state_.supply.size(); ++i) {
    if (state_.store_empty_at[i] < 0) continue;
    char text[96];
    std::snprintf(text, sizeof text, "%s: its store was empty, first at %.3f s", nameOf(i).c_str(),
                  rail::toSeconds(state_.store_empty_at[i]));
    told.emplace_back(text);
  }
  return told;
}

void Cosimulation::end(Outcome::Kind kind, const std::string& reason) {
  if (outcome_.ended()) return;
  under_way_ = false;
  outcome_.kind = kind;
  outcome_.reason = reason;
  outcome_.notes = notes();
  dynamics_.updateStoredEnergies(state_);
  for (RunObserver* observer : observers_) {
    try {
      observer->onEnd(state_, outcome_);
    } catch (const std::exception& error) {
      outcome_.kind = Outcome::Kind::kFailed;
      outcome_.reason = error.what();
    }
  }
}

void Cosimulation::guarded(const std::function<void()>& call) {
  try {
    call();
  } catch (const std::exception& error) {
    end(Outcome::Kind::kFailed, error.what());
  }
}

}  // namespace ltd
