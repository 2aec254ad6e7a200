#include "panels/lock_caller.hpp"

#include <gtest/gtest.h>

#include <future>
#include <memory>
#include <stdexcept>
#include <thread>

namespace viz {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

/// Asks for the answer until it is there, as a panel's timer does.
LockReply awaitReply(LockCaller& caller) {
  const auto until = Clock::now() + std::chrono::seconds(20);
  while (Clock::now() < until) {
    if (const auto reply = caller.poll()) return *reply;
    std::this_thread::yield();
  }
  return {false, "the test's own deadline"};
}

TEST(LockCallerTest, GivesTheAnswerOnce) {
  LockCaller caller([](const std::string& command, double value) {
    return LockReply{true, command + " " + std::to_string(static_cast<int>(value))};
  });
  EXPECT_FALSE(caller.poll());
  ASSERT_TRUE(caller.start("STEP", 10.0));
  EXPECT_TRUE(caller.busy());
  const LockReply reply = awaitReply(caller);
  EXPECT_TRUE(reply.accepted);
  EXPECT_EQ(reply.message, "STEP 10");
  EXPECT_FALSE(caller.busy());
  EXPECT_FALSE(caller.poll());
}

/// The service answers only when the test lets it: whoever draws must not notice.
TEST(LockCallerTest, NeitherStartNorPollWaits) {
  auto gate = std::make_shared<std::promise<void>>();
  auto open = std::make_shared<std::shared_future<void>>(gate->get_future());
  LockCaller caller([open](const std::string&, double) {
    open->wait();
    return LockReply{true, "late"};
  });
  ASSERT_TRUE(caller.start("RUN", 0.0));  // would never return if it waited
  EXPECT_FALSE(caller.poll());
  EXPECT_FALSE(caller.start("HOLD", 0.0)) << "two calls at once";
  gate->set_value();
  EXPECT_EQ(awaitReply(caller).message, "late");
}

TEST(LockCallerTest, ASilentServiceIsLeftAfterTheDeadline) {
  auto gate = std::make_shared<std::promise<void>>();
  auto open = std::make_shared<std::shared_future<void>>(gate->get_future());
  const auto began = Clock::now();
  {
    LockCaller caller(
        [open](const std::string&, double) {
          open->wait();
          return LockReply{true, "too late"};
        },
        milliseconds(50));
    ASSERT_TRUE(caller.start("HOLD", 0.0));
    const LockReply reply = awaitReply(caller);
    EXPECT_FALSE(reply.accepted);
    EXPECT_EQ(reply.message, "no answer to HOLD");
    EXPECT_TRUE(caller.start("RUN", 0.0)) << "the next command has its chance";
  }  // the destructor waits for a second at most
  EXPECT_GE(Clock::now() - began, milliseconds(50));
  EXPECT_LT(Clock::now() - began, std::chrono::seconds(15));
  gate->set_value();
}

TEST(LockCallerTest, AnExceptionIsAnAnswer) {
  LockCaller caller([](const std::string&, double) -> LockReply { throw std::runtime_error("no such host"); });
  ASSERT_TRUE(caller.start("RUN", 0.0));
  const LockReply reply = awaitReply(caller);
  EXPECT_FALSE(reply.accepted);
  EXPECT_EQ(reply.message, "no such host");
}

}  // namespace
}  // namespace viz
