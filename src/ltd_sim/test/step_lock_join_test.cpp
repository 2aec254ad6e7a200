// How a locomotive comes into a run, or back into it.

#include "step_lock_fixture.hpp"

namespace {

using Kind = loco::TractionMessage::Kind;

class StepLockJoinTest : public fixtures::StepLockTest {};

TEST_F(StepLockJoinTest, AJoinAnswersWithAllThatTheFirstStepNeeds) {
  const loco::JoinAnswer answer = lock_.onJoin(request(2, "/b"), 0.0);
  ASSERT_TRUE(answer.accepted);
  EXPECT_EQ(answer.id.run_id, 42u);
  EXPECT_EQ(answer.id.incarnation, 1u);
  EXPECT_EQ(answer.step, 0u);
  EXPECT_TRUE(answer.state.empty());
  EXPECT_EQ(answer.location_m, 2978.0);
  EXPECT_EQ(answer.speed_mps, 1.5);
  EXPECT_EQ(answer.configuration, "name: test");
  EXPECT_EQ(answer.locomotive_key, "train.groups.1.vehicle");
  EXPECT_FALSE(lock_.allJoined());
  lock_.onJoin(request(1, "/a"), 0.0);
  EXPECT_TRUE(lock_.allJoined());
}

TEST_F(StepLockJoinTest, AJoinThatDoesNotFitIsRefusedWithItsReason) {
  loco::JoinRequest other = request(1, "/a");
  other.protocol_version = 99;
  EXPECT_NE(lock_.onJoin(other, 0.0).reason.find("protocol version 99"), std::string::npos);
  other = request(1, "/a");
  other.build_id = "old";
  EXPECT_NE(lock_.onJoin(other, 0.0).reason.find("build old"), std::string::npos);
  other = request(1, "/a");
  other.arithmetic_fingerprint = 8;
  EXPECT_NE(lock_.onJoin(other, 0.0).reason.find("last digits"), std::string::npos);
  for (const std::uint32_t locomotive : {0u, 3u})
    EXPECT_NE(lock_.onJoin(request(locomotive, "/a"), 0.0).reason.find("2 locomotives"), std::string::npos);
}

TEST_F(StepLockJoinTest, ATakenSlotIsGivenToItsOwnNodeAgainButNotToAStranger) {
  joinBoth();
  const loco::JoinAnswer stranger = lock_.onJoin(request(1, "/stranger"), 1.0);
  EXPECT_FALSE(stranger.accepted);
  EXPECT_TRUE(stranger.wait);
  EXPECT_NE(stranger.reason.find("taken by /a"), std::string::npos);
  EXPECT_TRUE(lock_.onJoin(request(1, "/a"), 1.0).accepted);
}

TEST_F(StepLockJoinTest, ASlotIsGivenToAnotherNodeWhenItsConnectionIsClosedOrItsDeadlinePassed) {
  joinBoth();
  connected_ = false;
  EXPECT_TRUE(lock_.onJoin(request(1, "/c"), 1.0).accepted);
  connected_ = true;
  EXPECT_FALSE(lock_.onJoin(request(1, "/d"), 1.0).accepted);
  sendStep(0);
  lock_.tick(1.0);
  EXPECT_FALSE(lock_.onJoin(request(1, "/d"), 15.9).accepted);
  EXPECT_TRUE(lock_.onJoin(request(1, "/d"), 16.1).accepted);
}

TEST_F(StepLockJoinTest, WhyAMissingLocomotiveWasRefusedIsTold) {
  loco::JoinRequest old = request(2, "/b");
  old.build_id = "old";
  lock_.onJoin(old, 0.0);
  lock_.onJoin(request(1, "/a"), 0.0);
  EXPECT_NE(lock_.waitsFor(2.0, 1.0).find("loco_2 has not joined (/b was refused: build old"), std::string::npos);
  lock_.tick(61.0);
  EXPECT_NE(lock_.fault().find("build old"), std::string::npos);
}

TEST_F(StepLockJoinTest, ANewcomerInAnUnansweredStepGetsThatStepsState) {
  joinBoth();
  sendStep(5);
  const loco::JoinAnswer answer = lock_.onJoin(request(1, "/a"), 0.0);
  EXPECT_EQ(answer.step, 5u);
  EXPECT_EQ(answer.state, states_[0]);
  EXPECT_EQ(answer.id.incarnation, 3u);
  const std::size_t sent_before = sent_.size();
  lock_.tick(0.001);
  ASSERT_GT(sent_.size(), sent_before);
  EXPECT_EQ(sent_[sent_before].second.id.incarnation, 3u);
}

TEST_F(StepLockJoinTest, ANewcomerAfterTheAnswerStartsWithTheNextStep) {
  joinBoth();
  sendStep(5);
  lock_.onTraction(answer(1, 5, 5.0));
  const loco::JoinAnswer joined = lock_.onJoin(request(1, "/a"), 0.0);
  EXPECT_EQ(joined.step, 6u);
  EXPECT_EQ(joined.state, answer(1, 5, 5.0).traction.state);
  ASSERT_NE(lock_.port(0).answer(), nullptr);  // what was answered stays answered
}

TEST_F(StepLockJoinTest, OneWhoLostTheThreadIsOutUntilItJoinsAgain) {
  joinBoth();
  sendStep(5);
  loco::TractionMessage lost = answer(1, 5, 0.0);
  lost.kind = Kind::kNeedState;
  lock_.onTraction(lost);
  EXPECT_FALSE(lock_.joined(0));
  const std::size_t sent_before = sent_.size();
  lock_.tick(1.0);
  lock_.tick(2.0);
  for (std::size_t i = sent_before; i < sent_.size(); ++i) EXPECT_NE(sent_[i].first, 0u);
  EXPECT_TRUE(lock_.onJoin(request(1, "/a"), 2.0).accepted);
  EXPECT_TRUE(lock_.joined(0));
}

}  // namespace
