#include "ltd_sim/cosimulation.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdio>
#include <exception>
#include <utility>

#include "kilometres.hpp"
#include "rail_core/digest.hpp"
#include "rail_core/message_number.hpp"
#include "run_end.hpp"

namespace ltd {

namespace {

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

void Cosimulation::hold() {
  assert(!under_way_);
  if (!step_is_whole_) return;
  const StepRecord record{before_, state_, forces_, loco_forces_, answers_};
  guarded([&] {
    for (RunObserver* observer : observers_) observer->onHold(record);
  });
}

void Cosimulation::begin() {
  assert(!under_way_ && !outcome_.ended());
  under_way_ = true;
  step_is_whole_ = false;
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
    const std::string fault = scenario_.driver.give(*command, state_.driver);
    if (fault.empty()) return true;
    driver_port_->refuse(fault);
    noteRefusal(fault);
  }
  if (!driver_port_->silent()) return false;
  silence_ = "driver: no answer within " + rail::messageNumber(driver_port_->deadline_s()) + " s to the question of " +
             rail::fixedNumber(rail::toSeconds(time()), 3) + " s at " + kilometres(leadingLocation()) +
             ": the train brakes";
  scenario_.driver.giveSilence(state_.driver);
  return true;
}

void Cosimulation::noteRefusal(const std::string& fault) {
  constexpr std::size_t kMostRefusals = 10;  // chosen: whoever reads ten of them has understood
  for (const std::string& told : refused_answers_)
    if (told.find(fault) != std::string::npos) return;
  if (refused_answers_.size() == kMostRefusals) return;
  refused_answers_.push_back("driver: answer to the question of " + rail::fixedNumber(rail::toSeconds(time()), 3) +
                             " s refused: " + fault);
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
  std::string fault = modelFailure();  // first: of an answer that failed nothing else holds
  if (fault.empty()) fault = dynamics_.computeSpeeds(state_, forces_, answers_);
  if (fault.empty()) fault = checkSpeeds();
  if (!fault.empty()) {
    end(Outcome::Kind::kFailed,
        fault + " in step " + std::to_string(state_.step) + " at " + kilometres(locationOfFault()));
    return true;
  }
  state_.limit_watch.look(forces_.view);
  before_ = state_;  // of the large state, what the observers see
  dynamics_.advance(state_, forces_, answers_);
  for (std::size_t i = 0; i < ports_.size(); ++i) {
    mixIn(outcome_.exchange_digest, loco::payloadDigest(loco_forces_[i]));
    mixIn(outcome_.exchange_digest, loco::payloadDigest(*answers_[i]));
  }
  if (time() % scenario_.output.telemetry_interval == 0 || time() % scenario_.output.timeseries_interval == 0)
    dynamics_.updateStoredEnergies(state_);
  const StepRecord record{before_, state_, forces_, loco_forces_, answers_};
  under_way_ = false;
  step_is_whole_ = true;
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
    const double drift =
        std::abs(answers_[i]->speed_mps - dynamics_.nextSpeeds()[scenario_.train.locomotives[i].vehicle]);
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
  if (const std::optional<Ending> ending = findEnding(scenario_, dynamics_, forces_, silence_, state_))
    end(ending->kind, ending->reason);
}

std::vector<std::string> Cosimulation::notes() const {
  std::vector<std::string> told = scenario_.driver.notes(state_.driver);
  told.insert(told.end(), refused_answers_.begin(), refused_answers_.end());
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
