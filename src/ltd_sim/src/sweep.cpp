#include "sweep.hpp"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <mutex>
#include <optional>
#include <system_error>
#include <thread>

#include "ltd_sim/csv_file.hpp"
#include "ltd_sim/local_fleet.hpp"
#include "offline_run.hpp"
#include "rail_core/constants.hpp"

namespace ltd {

namespace {

std::vector<std::string> sweepColumns(const OfflineArguments& arguments) {
  std::vector<std::string> columns = {"run"};
  for (const auto& set : arguments.sets) columns.push_back(set.first);
  for (const char* column : {"outcome", "final_time_s", "final_location_km", "final_speed_mps", "energy_rail_train_J",
                             "energy_rim_train_J", "slip_loss_J", "coupler_loss_J", "energy_residual_relative"})
    columns.push_back(column);
  return columns;
}

std::vector<std::string> sweepRow(const std::string& name, const std::vector<rail::Override>& overrides,
                                  const Scenario& scenario, const RunResult& run) {
  std::vector<std::string> cells = {name};
  for (const rail::Override& o : overrides)
    cells.push_back(o.value.find(',') == std::string::npos ? o.value : '"' + o.value + '"');
  const std::size_t lead = scenario.train.locomotives.front().vehicle;
  const rail::EnergyAccount& a = run.state.account;
  cells.push_back(toString(run.outcome.kind));
  for (const double x : {static_cast<double>(run.state.step) * rail::toSeconds(scenario.macro_step),
                         run.state.s_m[lead] / rail::kMetresPerKilometre, run.state.v_mps[lead], a.traction_rail,
                         a.traction_rim, a.slip_loss, a.coupler_loss, a.residualRelative()})
    cells.push_back(allDigits(x));
  return cells;
}

/// The runs of one sweep, handed out to threads and taken back.
class Sweep {
 public:
  Sweep(const OfflineArguments& arguments, const std::vector<std::vector<rail::Override>>& combinations,
        const std::vector<Scenario>& scenarios, const BagFactory& bag_factory)
      : arguments_(arguments),
        combinations_(combinations),
        scenarios_(scenarios),
        bag_factory_(bag_factory),
        results_(scenarios.size()),
        file_(arguments.out + "/sweep.csv", sweepColumns(arguments)) {}

  int run() {
    std::vector<std::thread> helpers;
    const std::size_t jobs = std::min(static_cast<std::size_t>(arguments_.jobs), scenarios_.size());
    helpers.reserve(jobs);
    try {
      while (helpers.size() + 1 < jobs) helpers.emplace_back([this] { work(); });
    } catch (const std::system_error&) {
      // the machine gives no more threads: those that it gave do the work
    }
    work();
    for (std::thread& helper : helpers) helper.join();
    if (failure_) std::rethrow_exception(failure_);
    Outcome stopped;
    stopped.kind = Outcome::Kind::kStopped;
    return interrupted != 0 && status_ == 0 ? stopped.exitStatus() : status_;  // between two runs
  }

 private:
  std::string nameOf(std::size_t run) const {
    char name[24];
    std::snprintf(name, sizeof name, "%03zu", run + 1);
    return name;
  }

  void work() {
    for (;;) {
      std::size_t run = 0;
      {
        const std::lock_guard<std::mutex> lock(mutex_);
        if (next_ == scenarios_.size() || failure_ || interrupted != 0) return;
        run = next_++;
      }
      try {
        take(run, runOnce(scenarios_[run], arguments_.out + "/" + nameOf(run), bag_factory_, manner(run)));
      } catch (...) {
        const std::lock_guard<std::mutex> lock(mutex_);
        if (!failure_) failure_ = std::current_exception();
      }
    }
  }

  RunManner manner(std::size_t run) const {
    const bool alone = arguments_.jobs == 1;
    return {alone ? threadsThatPay(scenarios_[run]) : 1, nameOf(run) + " of " + nameOf(scenarios_.size() - 1) + ": ",
            alone && onTerminal()};
  }

  /// Tells and writes all that have ended and have nothing open before them.
  void take(std::size_t run, RunResult result) {
    const std::lock_guard<std::mutex> lock(mutex_);
    results_[run] = std::move(result);
    for (; told_ < results_.size() && results_[told_]; ++told_) {
      const RunResult& ended = *results_[told_];
      tell(scenarios_[told_], ended, arguments_.out + "/" + nameOf(told_));
      file_.row(sweepRow(nameOf(told_), combinations_[told_], scenarios_[told_], ended));
      file_.flush();
      if (status_ == 0) status_ = ended.outcome.exitStatus();
    }
  }

  const OfflineArguments& arguments_;
  const std::vector<std::vector<rail::Override>>& combinations_;
  const std::vector<Scenario>& scenarios_;
  const BagFactory& bag_factory_;
  std::mutex mutex_;  ///< guards what follows
  std::size_t next_ = 0, told_ = 0;
  std::vector<std::optional<RunResult>> results_;
  CsvFile file_;
  int status_ = 0;
  std::exception_ptr failure_;
};

}  // namespace

int runSweep(const OfflineArguments& arguments, const std::vector<std::vector<rail::Override>>& combinations,
             const std::vector<Scenario>& scenarios, const BagFactory& bag_factory) {
  makeDirectories(arguments.out);
  const int status = Sweep(arguments, combinations, scenarios, bag_factory).run();
  std::printf("a row for each run in %s/sweep.csv\n", arguments.out.c_str());
  return status;
}

}  // namespace ltd
