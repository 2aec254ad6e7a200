#include "ltd_sim/local_fleet.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <condition_variable>
#include <mutex>

#include "ltd_sim/cosimulation.hpp"

namespace {

/// Where locomotives that compute meet.
struct Meeting {
  std::mutex mutex;
  std::condition_variable came;
  std::size_t present = 0, most = 0;
};

/// Answers with its own number once `expected` compute at the same time, or after a while.
class WaitingLoco : public loco::Locomotive {
 public:
  WaitingLoco(Meeting& meeting, std::size_t expected, double number)
      : meeting_(meeting), expected_(expected), number_(number) {}
  std::size_t stateSize() const override { return 1; }
  loco::LocoStart equilibriumState(double, double) const override { return {{0.0}, ""}; }
  void step(const std::vector<double>& state, const loco::LocoForce& force, loco::LocoTraction& answer) override {
    std::unique_lock<std::mutex> lock(meeting_.mutex);
    ++meeting_.present;
    meeting_.most = std::max(meeting_.most, meeting_.present);
    meeting_.came.notify_all();
    meeting_.came.wait_for(lock, std::chrono::milliseconds(500), [this] { return meeting_.most >= expected_; });
    --meeting_.present;
    answer.step = force.step;
    answer.traction_N = number_;
    answer.state = state;
  }
  std::vector<loco::BodyPose> computePoses(const std::vector<double>&) const override { return {}; }

 private:
  Meeting& meeting_;
  std::size_t expected_;
  double number_;
};

std::size_t mostAtOnce(int threads) {
  Meeting meeting;
  std::vector<std::unique_ptr<loco::Locomotive>> locomotives;
  for (int i = 0; i < 3; ++i)
    locomotives.push_back(std::make_unique<WaitingLoco>(meeting, static_cast<std::size_t>(threads), 10.0 + i));
  ltd::LocalFleet fleet(std::move(locomotives), threads);
  std::vector<loco::LocoForce> forces(3);
  const std::vector<double> state = {0.0};
  for (std::uint64_t step = 0; step < 3; ++step) {
    for (std::size_t i = 0; i < 3; ++i) {
      forces[i].step = step;
      fleet.ports()[i]->send(forces[i], state);
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const loco::LocoTraction* answer = fleet.ports()[i]->answer();
      EXPECT_EQ(answer->step, step);
      EXPECT_EQ(answer->traction_N, 10.0 + static_cast<double>(i));
    }
  }
  return meeting.most;
}

TEST(LocalFleetTest, AsManyLocomotivesComputeAtOnceAsThereAreThreads) {
  EXPECT_EQ(mostAtOnce(1), 1u);
  EXPECT_EQ(mostAtOnce(2), 2u);
  EXPECT_EQ(mostAtOnce(3), 3u);
}

std::uint64_t digestOfRun(int threads) {
  const ltd::Scenario scenario = ltd::Scenario::load(std::string(CONFIG_DIR) + "/scenarios/paper_3d.yaml",
                                                     {{"run.end_time_s", "0.2"}, {"train.groups.1.count", "3"}});
  ltd::LocalFleet fleet(ltd::makeLocomotives(scenario), threads);
  ltd::Cosimulation run(scenario, fleet.ports(), {});
  run.start();
  while (!run.outcome().ended()) {
    run.begin();
    EXPECT_TRUE(run.tryCommit());
  }
  EXPECT_EQ(run.outcome().reason, "reached the end time 0.2 s");
  return run.outcome().exchange_digest;
}

TEST(LocalFleetTest, TheBitsOfARunDoNotDependOnTheThreads) {
  const std::uint64_t alone = digestOfRun(1);
  EXPECT_EQ(digestOfRun(2), alone);
  EXPECT_EQ(digestOfRun(3), alone);
}

TEST(LocalFleetTest, ThreadsAreForTrainsWithSeveral3dLocomotives) {
  const auto threads = [](const char* scenario, const std::vector<rail::Override>& overrides) {
    return ltd::threadsThatPay(
        ltd::Scenario::load(std::string(CONFIG_DIR) + "/scenarios/" + scenario + ".yaml", overrides));
  };
  const int processors = static_cast<int>(std::max(std::thread::hardware_concurrency(), 1u));
  EXPECT_EQ(threads("paper_1d", {}), 1);
  EXPECT_EQ(threads("paper_2d", {}), 1);
  EXPECT_EQ(threads("paper_3d", {}), std::min(processors, 3));
  EXPECT_EQ(threads("paper_3d", {{"train.groups.0.count", "1"}}), 1);
}

}  // namespace
