#include "loco_dynamics/loco_session.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "loco_dynamics/local_port.hpp"
#include "loco_dynamics/loco_1d.hpp"

namespace {

using Kind = loco::TractionMessage::Kind;

class LocoSessionTest : public ::testing::Test {
 protected:
  LocoSessionTest() {
    joined_.accepted = true;
    joined_.id = {42, 1, 3, 2};
    joined_.step = 10;
    joined_.state = {100.0, 5.0};
  }

  static std::unique_ptr<loco::Locomotive> makeLoco() {
    return std::make_unique<loco::Loco1d>(loco::Loco1d::Parameters{134000.0, 134000.0, 0.35});
  }

  void start() { session_.start(makeLoco(), joined_); }

  loco::ForceMessage force(std::uint64_t step) const {
    loco::ForceMessage message;
    message.id = joined_.id;
    message.force.step = step;
    message.force.step_length = 2000000;
    message.force.traction_reference_N = 1000.0 * static_cast<double>(step);
    return message;
  }

  loco::JoinAnswer joined_;
  loco::LocoSession session_;
};

TEST_F(LocoSessionTest, BeforeJoiningEverythingIsDropped) {
  EXPECT_TRUE(session_.needsJoin());
  EXPECT_EQ(session_.onForce(force(10)), nullptr);
  EXPECT_EQ(session_.counters().dropped, 1u);
}

TEST_F(LocoSessionTest, TheNextStepIsComputedFromTheStateOfTheJoin) {
  start();
  const loco::TractionMessage* answer = session_.onForce(force(10));
  ASSERT_NE(answer, nullptr);
  EXPECT_EQ(answer->kind, Kind::kAnswer);
  EXPECT_EQ(answer->traction.step, 10u);
  EXPECT_EQ(answer->id.incarnation, 3u);
  EXPECT_DOUBLE_EQ(answer->traction.speed_mps, 5.0 + 0.002 * 10000.0 / 134000.0);
}

TEST_F(LocoSessionTest, AForceThatComesTwiceGetsTheSameAnswerAndIsComputedOnce) {
  start();
  const loco::LocoTraction first = session_.onForce(force(10))->traction;
  const loco::TractionMessage* again = session_.onForce(force(10));
  ASSERT_NE(again, nullptr);
  EXPECT_TRUE(loco::samePayload(first, again->traction));
  EXPECT_EQ(session_.counters().computed, 1u);
  EXPECT_EQ(session_.counters().repeated, 1u);
}

TEST_F(LocoSessionTest, AStepThatWasSkippedNeedsTheStateAgain) {
  start();
  const loco::TractionMessage* answer = session_.onForce(force(11));
  ASSERT_NE(answer, nullptr);
  EXPECT_EQ(answer->kind, Kind::kNeedState);
  EXPECT_EQ(answer->traction.step, 11u);
  EXPECT_TRUE(session_.needsJoin());
}

TEST_F(LocoSessionTest, TheLastStepWithOtherForcesNeedsTheStateAgain) {
  start();
  session_.onForce(force(10));
  loco::ForceMessage changed = force(10);
  changed.force.grade_N = 1.0;
  EXPECT_EQ(session_.onForce(changed)->kind, Kind::kNeedState);
}

TEST_F(LocoSessionTest, OtherRunEpochIncarnationOrLocomotiveIsDropped) {
  start();
  for (int field = 0; field < 4; ++field) {
    loco::ForceMessage message = force(10);
    if (field == 0) message.id.run_id = 43;
    if (field == 1) message.id.epoch = 2;
    if (field == 2) message.id.incarnation = 2;
    if (field == 3) message.id.locomotive = 1;
    EXPECT_EQ(session_.onForce(message), nullptr) << field;
  }
  EXPECT_EQ(session_.counters().dropped, 4u);
  EXPECT_FALSE(session_.needsJoin());
}

TEST_F(LocoSessionTest, AForceThatIsNotANumberIsDropped) {
  start();
  loco::ForceMessage message = force(10);
  message.force.grade_N = std::nan("");
  EXPECT_EQ(session_.onForce(message), nullptr);
  EXPECT_EQ(session_.counters().dropped, 1u);
}

TEST_F(LocoSessionTest, AfterJoiningAgainTheStepIsRepeatedWithTheSameBits) {
  start();
  const loco::LocoTraction first = session_.onForce(force(10))->traction;
  joined_.id.incarnation = 4;
  start();
  const loco::TractionMessage* again = session_.onForce(force(10));
  ASSERT_NE(again, nullptr);
  EXPECT_EQ(again->id.incarnation, 4u);
  EXPECT_TRUE(loco::samePayload(first, again->traction));
}

TEST_F(LocoSessionTest, WithoutAStateItStartsInEquilibriumAtThePlaceGiven) {
  joined_.state.clear();
  joined_.location_m = 3000.0;
  joined_.speed_mps = 1.5;
  start();
  const loco::TractionMessage* answer = session_.onForce(force(10));
  ASSERT_NE(answer, nullptr);
  EXPECT_DOUBLE_EQ(answer->traction.speed_mps, 1.5 + 0.002 * 10000.0 / 134000.0);
  EXPECT_DOUBLE_EQ(answer->traction.location_m, 3000.0 + 0.002 * answer->traction.speed_mps);
}

/// Stands nowhere.
class Derailed : public loco::Loco1d {
 public:
  Derailed() : Loco1d({134000.0, 134000.0, 0.35}) {}
  loco::LocoStart equilibriumState(double, double) const override { return {{}, "wheelset 1: wheel lift"}; }
};

TEST_F(LocoSessionTest, WhereItCannotStartEveryStepFailsWithTheReason) {
  joined_.state.clear();
  session_.start(std::make_unique<Derailed>(), joined_);
  for (int i = 0; i < 2; ++i) {
    const loco::TractionMessage* answer = session_.onForce(force(10));
    ASSERT_NE(answer, nullptr);
    EXPECT_EQ(answer->kind, Kind::kFailed);
    EXPECT_EQ(answer->traction.step, 10u);
    EXPECT_EQ(answer->traction.failure, "wheelset 1: wheel lift");
  }
}

TEST_F(LocoSessionTest, AfterAStartThatFailedItGoesOnFromAState) {
  loco::JoinAnswer nowhere = joined_;
  nowhere.state.clear();
  session_.start(std::make_unique<Derailed>(), nowhere);
  start();
  EXPECT_EQ(session_.onForce(force(10))->kind, Kind::kAnswer);
}

TEST(LocalPortTest, WhereItCannotStartItsAnswerIsTheReason) {
  loco::LocalPort port(std::make_unique<Derailed>());
  loco::LocoForce force;
  force.step = 7;
  port.send(force, {});
  EXPECT_EQ(port.answer()->step, 7u);
  EXPECT_EQ(port.answer()->failure, "wheelset 1: wheel lift");
  port.send(force, {100.0, 5.0});
  EXPECT_EQ(port.answer()->failure, "");
}

}  // namespace
