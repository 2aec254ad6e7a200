#include "offline_run.hpp"

#include <unistd.h>

#include <cstdio>

#include "ltd_sim/cosimulation.hpp"
#include "ltd_sim/local_fleet.hpp"
#include "ltd_sim/progress.hpp"
#include "ltd_sim/run_outputs.hpp"
#include "rail_core/constants.hpp"
#include "rail_core/message_number.hpp"

namespace ltd {

volatile std::sig_atomic_t interrupted = 0;

bool onTerminal() { return isatty(STDERR_FILENO) != 0; }

RunResult runOnce(const Scenario& scenario, const std::string& folder, const BagFactory& bag_factory,
                  const RunManner& manner) {
  if (scenario.driver.external())
    throw rail::ConfigError({scenario.file + ": driver.kind = external: nobody can answer offline: run it in the graph "
                                             "(roslaunch), or give another kind"});
  LocalFleet fleet(makeLocomotives(scenario), manner.threads);
  RunOutputs outputs(scenario, folder);
  std::unique_ptr<RunObserver> bag = bag_factory ? bag_factory(scenario, folder) : nullptr;
  ProgressMeter progress(scenario, manner.rewrites ? 0.5 : 5.0, [&manner](const Progress& p) {
    std::fprintf(stderr, manner.rewrites ? "\r%s%s \033[K" : "%s%s\n", manner.label.c_str(), toString(p).c_str());
  });
  std::vector<RunObserver*> observers = {&progress};
  if (bag) observers.push_back(bag.get());
  observers.push_back(&outputs);  // outcome.yaml comes last: when it is there, everything is

  Cosimulation cosimulation(scenario, fleet.ports(), observers);
  cosimulation.start();
  while (!cosimulation.outcome().ended()) {
    if (interrupted != 0) {
      cosimulation.end(Outcome::Kind::kStopped, "interrupted");
      break;
    }
    cosimulation.begin();
    cosimulation.tryCommit();
  }
  if (manner.rewrites) std::fprintf(stderr, "\r\033[K");
  return {cosimulation.outcome(), cosimulation.state()};
}

void tell(const Scenario& scenario, const RunResult& run, const std::string& folder) {
  const rail::EnergyAccount& a = run.state.account;
  const double lead_v = run.state.v_mps[scenario.train.locomotives.front().vehicle];
  std::printf("%s: %s: %s\n", scenario.name.c_str(), toString(run.outcome.kind).c_str(), run.outcome.reason.c_str());
  std::printf("  time %.3f s, speed %s km/h, traction at the rail %s kWh, residual of the account %s\n",
              static_cast<double>(run.state.step) * rail::toSeconds(scenario.macro_step),
              rail::fixedNumber(lead_v * rail::kKmphPerMps, 3).c_str(),
              rail::fixedNumber(a.traction_rail / rail::kJoulesPerKilowattHour, 3).c_str(),
              rail::messageNumber(a.residualRelative()).c_str());
  for (const std::string& note : run.outcome.notes) std::printf("  note: %s\n", note.c_str());
  std::printf("  results in %s\n", folder.c_str());
}

}  // namespace ltd
