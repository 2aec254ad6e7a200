#include <cmath>

#include "step_lock_fixture.hpp"

namespace {

using fixtures::StepLockTest;
using Kind = loco::TractionMessage::Kind;

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
