// The lock between the train and its locomotives over a transport that drops, doubles and delays messages, with
// locomotives that are killed and come back: the bits of the run must be those of a run in one process.

#include <gtest/gtest.h>

#include <deque>
#include <memory>

#include "loco_dynamics/local_port.hpp"
#include "loco_dynamics/loco_factory.hpp"
#include "loco_dynamics/loco_session.hpp"
#include "ltd_sim/cosimulation.hpp"
#include "ltd_sim/step_lock.hpp"

namespace {

const std::string kScenarioFile = std::string(CONFIG_DIR) + "/scenarios/paper_1d.yaml";

ltd::Outcome runInOneProcess(const ltd::Scenario& scenario) {
  rail::Problems problems;
  std::vector<std::unique_ptr<loco::LocalPort>> owned;
  std::vector<loco::LocoPort*> ports;
  for (const ltd::LocoUnit& unit : scenario.train.locomotives) {
    owned.push_back(std::make_unique<loco::LocalPort>(loco::makeLocomotive(scenario.document, unit.key, problems)));
    ports.push_back(owned.back().get());
  }
  ltd::Cosimulation cosimulation(scenario, ports, {});
  while (!cosimulation.outcome().ended()) {
    cosimulation.begin();
    cosimulation.tryCommit();
  }
  return cosimulation.outcome();
}

/// What the transport does to messages: every n-th, counted over all, 0 = never.
struct Mischief {
  int drop_every = 0;
  int double_every = 0;
  int delay_every = 0;       ///< it arrives after the next message
  int kill_every_steps = 0;  ///< kill one locomotive, in turn; it joins again
  bool join_backwards = false;
};

/// Train and locomotives as in the graph, but for the transport, in one thread and with a clock of its own.
class LossyGraph {
 public:
  LossyGraph(const ltd::Scenario& scenario, const Mischief& mischief)
      : scenario_(scenario),
        mischief_(mischief),
        sessions_(scenario.train.locomotives.size()),
        lock_(
            settings(scenario),
            [this](std::size_t i, const loco::ForceMessage& m) {
              post(to_locos_, {i, m});
            },
            [](std::size_t) { return true; }) {
    std::vector<loco::LocoPort*> ports;
    for (std::size_t i = 0; i < lock_.size(); ++i) ports.push_back(&lock_.port(i));
    cosimulation_ = std::make_unique<ltd::Cosimulation>(scenario, ports, std::vector<ltd::RunObserver*>{});
    for (std::size_t i = 0; i < lock_.size(); ++i) {
      const std::size_t vehicle = scenario.train.locomotives[i].vehicle;
      lock_.setStart(i, cosimulation_->state().s_m[vehicle], cosimulation_->state().v_mps[vehicle]);
    }
    for (auto& session : sessions_) session = std::make_unique<loco::LocoSession>();
  }

  ltd::Outcome run() {
    while (!cosimulation_->outcome().ended()) {
      joinThoseWhoMust();
      if (!cosimulation_->stepUnderWay()) {
        killInTurn();
        cosimulation_->begin();
      }
      deliver();
      if (cosimulation_->tryCommit()) continue;
      now_s_ += 0.02;  // nothing more is under way: wall time passes until something is sent again
      lock_.tick(now_s_);
      if (!lock_.fault().empty()) cosimulation_->end(ltd::Outcome::Kind::kFailed, lock_.fault());
    }
    return cosimulation_->outcome();
  }

  const ltd::StepLock::Counters& counters() const { return lock_.counters(); }
  int kills() const { return kills_; }

 private:
  template <typename Message>
  struct Letter {
    std::size_t loco;
    Message message;
  };
  using ToLocos = std::deque<Letter<loco::ForceMessage>>;
  using ToTrain = std::deque<Letter<loco::TractionMessage>>;

  static ltd::StepLock::Settings settings(const ltd::Scenario& scenario) {
    ltd::StepLock::Settings s;
    s.id = {1, 1, 0, 0};
    s.configuration = scenario.document.text();
    for (const ltd::LocoUnit& unit : scenario.train.locomotives) {
      s.loco_keys.push_back(unit.key);
      s.state_sizes.push_back(2);
    }
    s.step_length = scenario.macro_step;
    return s;
  }

  template <typename Queue>
  void post(Queue& queue, typename Queue::value_type letter) {
    ++posted_;
    const auto isTurn = [this](int every) { return every > 0 && posted_ % every == 0; };
    if (isTurn(mischief_.drop_every)) return;
    if (isTurn(mischief_.double_every)) queue.push_back(letter);
    if (isTurn(mischief_.delay_every) && !queue.empty()) {
      queue.insert(queue.end() - 1, letter);
    } else {
      queue.push_back(std::move(letter));
    }
  }

  void deliver() {
    while (!to_locos_.empty() || !to_train_.empty()) {
      if (!to_locos_.empty()) {
        const auto letter = to_locos_.front();
        to_locos_.pop_front();
        const loco::TractionMessage* answer = sessions_[letter.loco]->onForce(letter.message);
        if (answer != nullptr) post(to_train_, {letter.loco, *answer});
      }
      if (!to_train_.empty()) {
        const auto letter = to_train_.front();
        to_train_.pop_front();
        lock_.onTraction(letter.message);
      }
    }
  }

  void joinThoseWhoMust() {
    for (std::size_t j = 0; j < sessions_.size(); ++j) {
      const std::size_t i = mischief_.join_backwards ? sessions_.size() - 1 - j : j;
      if (!sessions_[i]->needsJoin()) continue;
      loco::JoinRequest request;
      request.locomotive = static_cast<std::uint32_t>(i + 1);
      request.node = "/loco_" + std::to_string(i + 1);
      const loco::JoinAnswer joined = lock_.onJoin(request, now_s_);
      ASSERT_TRUE(joined.accepted) << joined.reason;
      rail::Problems problems;
      const rail::Document document = rail::Document::parse(joined.configuration, "join", problems);
      sessions_[i]->start(loco::makeLocomotive(document, joined.locomotive_key, problems), joined);
    }
  }

  void killInTurn() {
    const std::uint64_t step = cosimulation_->state().step;
    if (mischief_.kill_every_steps == 0 || step == 0) return;
    if (step % static_cast<std::uint64_t>(mischief_.kill_every_steps) != 0) return;
    sessions_[static_cast<std::size_t>(kills_++) % sessions_.size()] = std::make_unique<loco::LocoSession>();
  }

  const ltd::Scenario& scenario_;
  Mischief mischief_;
  std::vector<std::unique_ptr<loco::LocoSession>> sessions_;
  ltd::StepLock lock_;
  std::unique_ptr<ltd::Cosimulation> cosimulation_;
  ToLocos to_locos_;
  ToTrain to_train_;
  long posted_ = 0;
  int kills_ = 0;
  double now_s_ = 0.0;
};

class LossyExchangeTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    scenario_ = new ltd::Scenario(ltd::Scenario::load(kScenarioFile, {}));
    reference_ = new ltd::Outcome(runInOneProcess(*scenario_));
  }
  static void TearDownTestSuite() {
    delete scenario_;
    delete reference_;
  }
  static const ltd::Scenario* scenario_;
  static const ltd::Outcome* reference_;
};
const ltd::Scenario* LossyExchangeTest::scenario_ = nullptr;
const ltd::Outcome* LossyExchangeTest::reference_ = nullptr;

void expectSame(const ltd::Outcome& outcome, const ltd::Outcome& reference) {
  EXPECT_EQ(outcome.kind, ltd::Outcome::Kind::kFinished) << outcome.reason;
  EXPECT_EQ(outcome.exchange_digest, reference.exchange_digest);
}

TEST_F(LossyExchangeTest, AReliableTransportGivesTheBitsOfOneProcess) {
  LossyGraph graph(*scenario_, {});
  expectSame(graph.run(), *reference_);
  EXPECT_EQ(graph.counters().resent, 0u);
  EXPECT_EQ(graph.counters().refused, 0u);
}

TEST_F(LossyExchangeTest, TheOrderOfJoiningDoesNotMatter) {
  Mischief mischief;
  mischief.join_backwards = true;
  expectSame(LossyGraph(*scenario_, mischief).run(), *reference_);
}

TEST_F(LossyExchangeTest, EveryTenthMessageDroppedLeavesTheBitsAlone) {
  Mischief mischief;
  mischief.drop_every = 10;
  LossyGraph graph(*scenario_, mischief);
  expectSame(graph.run(), *reference_);
  EXPECT_GT(graph.counters().resent, 10000u);  // of 6 messages a step over 96806 steps a tenth is lost
}

TEST_F(LossyExchangeTest, EveryTenthMessageDoubledLeavesTheBitsAlone) {
  Mischief mischief;
  mischief.double_every = 10;
  LossyGraph graph(*scenario_, mischief);
  expectSame(graph.run(), *reference_);
  EXPECT_GT(graph.counters().repeated, 10000u);
}

TEST_F(LossyExchangeTest, DroppedDoubledDelayedAndKilledTogetherLeaveTheBitsAlone) {
  Mischief mischief;
  mischief.drop_every = 11;
  mischief.double_every = 7;
  mischief.delay_every = 5;
  mischief.kill_every_steps = 997;
  mischief.join_backwards = true;
  LossyGraph graph(*scenario_, mischief);
  expectSame(graph.run(), *reference_);
  EXPECT_GT(graph.kills(), 90);
}

}  // namespace
