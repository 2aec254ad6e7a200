#include "ltd_sim/step_lock.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

namespace {

using Kind = loco::TractionMessage::Kind;

/// A lock for two locomotives whose messages are kept in a list.
class StepLockTest : public ::testing::Test {
 protected:
  StepLockTest()
      : lock_(
            settings(), [this](std::size_t i, const loco::ForceMessage& m) { sent_.emplace_back(i, m); },
            [this](std::size_t) { return connected_; }) {
    lock_.tick(0.0);
    lock_.setStart(0, 3000.0, 1.5);
    lock_.setStart(1, 2978.0, 1.5);
  }

  static ltd::StepLock::Settings settings() {
    ltd::StepLock::Settings s;
    s.id = {42, 1, 0, 0};
    s.build_id = "build";
    s.arithmetic_fingerprint = 7;
    s.configuration = "name: test";
    s.loco_keys = {"train.groups.0.vehicle", "train.groups.1.vehicle"};
    s.state_sizes = {2, 2};
    s.step_length = 2000000;
    s.join_deadline_s = 60.0;
    s.answer_deadline_s = 30.0;
    return s;
  }

  static loco::JoinRequest request(std::uint32_t locomotive, const std::string& node) {
    return {loco::kProtocolVersion, "build", 7, locomotive, node};
  }

  void joinBoth() {
    ASSERT_TRUE(lock_.onJoin(request(1, "/a"), 0.0).accepted);
    ASSERT_TRUE(lock_.onJoin(request(2, "/b"), 0.0).accepted);
  }

  /// Asks both for a step from the given states.
  void sendStep(std::uint64_t step) {
    for (std::size_t i = 0; i < 2; ++i) {
      loco::LocoForce force;
      force.step = step;
      force.location_m = 3000.0;
      states_[i] = {static_cast<double>(step), 1.0};
      lock_.port(i).send(force, states_[i]);
    }
  }

  loco::TractionMessage answer(std::uint32_t locomotive, std::uint64_t step, double traction_N) {
    loco::TractionMessage message;
    message.id = {42, 1, lock_.incarnation(locomotive - 1), locomotive};
    message.traction.step = step;
    message.traction.traction_N = traction_N;
    message.traction.state = {static_cast<double>(step) + 1.0, 2.0};
    return message;
  }

  std::vector<std::pair<std::size_t, loco::ForceMessage>> sent_;
  std::vector<double> states_[2];
  bool connected_ = true;
  ltd::StepLock lock_;
};

TEST_F(StepLockTest, AJoinAnswersWithAllThatTheFirstStepNeeds) {
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

TEST_F(StepLockTest, AJoinThatDoesNotFitIsRefusedWithItsReason) {
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

TEST_F(StepLockTest, ATakenSlotIsGivenToItsOwnNodeAgainButNotToAStranger) {
  joinBoth();
  const loco::JoinAnswer stranger = lock_.onJoin(request(1, "/stranger"), 1.0);
  EXPECT_FALSE(stranger.accepted);
  EXPECT_TRUE(stranger.wait);
  EXPECT_NE(stranger.reason.find("taken by /a"), std::string::npos);
  EXPECT_TRUE(lock_.onJoin(request(1, "/a"), 1.0).accepted);
}

TEST_F(StepLockTest, ASlotIsGivenToAnotherNodeWhenItsConnectionIsClosedOrItsDeadlinePassed) {
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

TEST_F(StepLockTest, TheFirstAnswerIsTakenAndItsEchoesAreCounted) {
  joinBoth();
  sendStep(0);
  EXPECT_EQ(lock_.port(0).answer(), nullptr);
  lock_.onTraction(answer(1, 0, 5.0));
  ASSERT_NE(lock_.port(0).answer(), nullptr);
  EXPECT_EQ(lock_.port(0).answer()->traction_N, 5.0);
  EXPECT_EQ(lock_.port(1).answer(), nullptr);
  lock_.onTraction(answer(1, 0, 5.0));
  EXPECT_EQ(lock_.counters().repeated, 1u);
  sendStep(1);
  lock_.onTraction(answer(1, 0, 5.0));  // late echo of a committed step
  EXPECT_EQ(lock_.port(0).answer(), nullptr);
  EXPECT_EQ(lock_.counters().repeated, 2u);
  EXPECT_EQ(lock_.counters().refused, 0u);
  EXPECT_TRUE(lock_.fault().empty());
}

TEST_F(StepLockTest, TwoDifferentAnswersToOneStepEndTheRun) {
  joinBoth();
  sendStep(0);
  lock_.onTraction(answer(2, 0, 5.0));
  lock_.onTraction(answer(2, 0, std::nextafter(5.0, 6.0)));
  EXPECT_NE(lock_.fault().find("loco_2 is not deterministic"), std::string::npos);
}

TEST_F(StepLockTest, ADifferentAnswerToTheStepJustCommittedEndsTheRunToo) {
  joinBoth();
  sendStep(0);
  lock_.onTraction(answer(1, 0, 5.0));
  sendStep(1);
  lock_.onTraction(answer(1, 0, 5.0));
  EXPECT_TRUE(lock_.fault().empty());
  lock_.onTraction(answer(1, 0, 6.0));
  EXPECT_NE(lock_.fault().find("loco_1 is not deterministic"), std::string::npos);
}

TEST_F(StepLockTest, WhyAMissingLocomotiveWasRefusedIsTold) {
  loco::JoinRequest old = request(2, "/b");
  old.build_id = "old";
  lock_.onJoin(old, 0.0);
  lock_.onJoin(request(1, "/a"), 0.0);
  EXPECT_NE(lock_.waitsFor(2.0, 1.0).find("loco_2 has not joined (/b was refused: build old"), std::string::npos);
  lock_.tick(61.0);
  EXPECT_NE(lock_.fault().find("build old"), std::string::npos);
}

TEST_F(StepLockTest, AnswersWhoseIdsStepOrNumbersDoNotFitAreRefused) {
  joinBoth();
  sendStep(3);
  std::vector<loco::TractionMessage> bad(8, answer(1, 3, 5.0));
  bad[0].id.run_id = 1;
  bad[1].id.epoch = 2;
  bad[2].id.incarnation = 77;
  bad[3].id.locomotive = 9;
  bad[4].traction.step = 4;
  bad[5].traction.traction_N = std::nan("");
  bad[6].traction.state = {1.0};
  bad[7].id.locomotive = 0;
  for (const loco::TractionMessage& message : bad) lock_.onTraction(message);
  EXPECT_EQ(lock_.counters().refused, 8u);
  EXPECT_FALSE(lock_.counters().last_refused.empty());
  EXPECT_EQ(lock_.port(0).answer(), nullptr);
  EXPECT_TRUE(lock_.fault().empty());
}

TEST_F(StepLockTest, WhatIsNotAnsweredIsSentAgainEveryInterval) {
  joinBoth();
  sendStep(0);
  EXPECT_EQ(sent_.size(), 2u);
  lock_.tick(10.0);  // counts from here
  lock_.tick(10.09);
  EXPECT_EQ(sent_.size(), 2u);
  lock_.onTraction(answer(2, 0, 1.0));
  lock_.tick(10.11);
  ASSERT_EQ(sent_.size(), 3u);
  EXPECT_EQ(sent_.back().first, 0u);
  EXPECT_TRUE(loco::samePayload(sent_.back().second.force, sent_.front().second.force));
  lock_.tick(10.15);
  lock_.tick(10.22);
  EXPECT_EQ(sent_.size(), 4u);
  EXPECT_EQ(lock_.counters().resent, 2u);
}

TEST_F(StepLockTest, ANewcomerInAnUnansweredStepGetsThatStepsState) {
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

TEST_F(StepLockTest, ANewcomerAfterTheAnswerStartsWithTheNextStep) {
  joinBoth();
  sendStep(5);
  lock_.onTraction(answer(1, 5, 5.0));
  const loco::JoinAnswer joined = lock_.onJoin(request(1, "/a"), 0.0);
  EXPECT_EQ(joined.step, 6u);
  EXPECT_EQ(joined.state, answer(1, 5, 5.0).traction.state);
  ASSERT_NE(lock_.port(0).answer(), nullptr);  // what was answered stays answered
}

TEST_F(StepLockTest, OneWhoLostTheThreadIsOutUntilItJoinsAgain) {
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

TEST_F(StepLockTest, WhoKeepsTheRunWaitingIsNamed) {
  lock_.onJoin(request(1, "/a"), 0.0);
  EXPECT_EQ(lock_.waitsFor(0.5, 1.0), "");
  EXPECT_EQ(lock_.waitsFor(1.5, 1.0), "loco_2 has not joined");
  lock_.onJoin(request(2, "/b"), 2.0);
  sendStep(7);
  lock_.tick(10.0);
  lock_.onTraction(answer(1, 7, 0.0));
  EXPECT_EQ(lock_.waitsFor(12.0, 1.0), "loco_2 has not answered step 7 for 2.0 s");
}

TEST_F(StepLockTest, DeadlinesForJoiningAndAnsweringEndTheRunByName) {
  lock_.onJoin(request(1, "/a"), 0.0);
  lock_.tick(59.9);
  EXPECT_TRUE(lock_.fault().empty());
  lock_.tick(60.1);
  EXPECT_EQ(lock_.fault(), "loco_2 has not joined within 60.0 s");
}

TEST_F(StepLockTest, TheDeadlineForAnAnswerCountsFromTheSending) {
  joinBoth();
  sendStep(9);
  lock_.tick(100.0);
  lock_.onTraction(answer(2, 9, 0.0));
  lock_.tick(129.9);
  EXPECT_TRUE(lock_.fault().empty());
  lock_.tick(130.1);
  EXPECT_EQ(lock_.fault(), "loco_1 has not answered step 9 within 30.0 s");
}

TEST_F(StepLockTest, AModelsFailureIsHandedOnAsItsAnswer) {
  joinBoth();
  sendStep(0);
  loco::TractionMessage failed = answer(1, 0, std::nan(""));
  failed.kind = Kind::kFailed;
  failed.traction.failure = "axle 3: no number";
  lock_.onTraction(failed);
  ASSERT_NE(lock_.port(0).answer(), nullptr);
  EXPECT_EQ(lock_.port(0).answer()->failure, "axle 3: no number");
}

}  // namespace
