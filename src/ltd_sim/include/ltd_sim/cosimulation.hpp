#pragma once

#include <functional>
#include <vector>

#include "loco_dynamics/loco_port.hpp"
#include "ltd_sim/driver_port.hpp"
#include "ltd_sim/outcome.hpp"
#include "ltd_sim/run_observer.hpp"
#include "ltd_sim/scenario.hpp"
#include "ltd_sim/train_dynamics.hpp"

namespace ltd {

/// Drives the train and its locomotives, macro step by macro step:
///   begin()      forces at t_k, sent to every locomotive; a driver in another program is asked first
///   tryCommit()  once he and all N have answered: speeds compared (the paper's synchronisation check), one step of
///                LTD with the very forces that were sent, energies, observers, end of the run
/// An observer that throws (a full disk, say) fails the run with its reason; the others still see the end.
/// Never waits: whoever calls decides how. Sums run in index order, so the result does not depend on who answers first.
class Cosimulation {
 public:
  /// Keeps references to scenario and ports (one per locomotive, from the head); observers are called in order.
  /// @param driver  needed if the scenario's driver is in another program
  Cosimulation(const Scenario& scenario, std::vector<loco::LocoPort*> ports, std::vector<RunObserver*> observers,
               DriverPort* driver = nullptr);

  /// Tells the observers of the start. Call once, before begin().
  void start();
  /// Tells the observers that the run stands still. No step under way; does nothing before the first, nor after one
  /// that was given up: its forces and answers belong to no state.
  void hold();

  /// @pre no step under way, not ended
  void begin();
  /// @return true if the step was committed (or the run failed in it)
  bool tryCommit();
  bool stepUnderWay() const { return under_way_; }
  /// A step is under way and waits for the driver's word.
  bool waitsForDriver() const { return asks_driver_; }

  /// Ends the run from outside (stopped or failed); a step under way is given up. Does nothing if it has ended.
  void end(Outcome::Kind kind, const std::string& reason);

  const Outcome& outcome() const { return outcome_; }
  const TrainState& state() const { return state_; }
  rail::Nanoseconds time() const { return static_cast<rail::Nanoseconds>(state_.step) * scenario_.macro_step; }
  double leadingLocation() const { return dynamics_.leadingLocation(state_); }
  double leadingSpeed() const { return dynamics_.leadingSpeed(state_); }
  const TrainForces& forces() const { return forces_; }
  /// What a reader of the results should know, though the run goes on: late arrivals, speed limits exceeded, empty
  /// stores, an external driver who is silent or whose answers were refused.
  std::vector<std::string> notes() const;
  /// Largest difference of a locomotive's speed from LTD's so far [m/s].
  double largestDrift() const { return largest_drift_mps_; }

 private:
  void sendForces();
  bool takeCommand();
  void noteRefusal(const std::string& fault);
  bool gatherAnswers();
  std::string modelFailure() const;
  double locationOfFault() const;
  std::string checkSpeeds();
  void checkEnd();
  void guarded(const std::function<void()>& call);

  const Scenario& scenario_;
  std::vector<loco::LocoPort*> ports_;
  std::vector<RunObserver*> observers_;
  DriverPort* driver_port_;
  TrainDynamics dynamics_;
  TrainState state_;
  TrainSnapshot before_;
  TrainForces forces_;
  std::vector<loco::LocoForce> loco_forces_;
  std::vector<const loco::LocoTraction*> answers_;
  Outcome outcome_;
  bool under_way_ = false;
  bool step_is_whole_ = false;  ///< forces and answers are those of the step that led to the state
  bool asks_driver_ = false;
  std::string silence_;                       ///< since when the driver has been silent, in words; empty: he has not
  std::vector<std::string> refused_answers_;  ///< the driver's, each fault where it came first, in words
  double largest_drift_mps_ = 0.0;
};

}  // namespace ltd
