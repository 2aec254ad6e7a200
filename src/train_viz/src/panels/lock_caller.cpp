#include "lock_caller.hpp"

#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>

namespace viz {

using Clock = std::chrono::steady_clock;

struct LockCaller::Pending {
  std::mutex mutex;
  std::condition_variable answered;
  std::optional<LockReply> reply;
  Clock::time_point until;
};

LockCaller::LockCaller(Call call, std::chrono::milliseconds deadline) : call_(std::move(call)), deadline_(deadline) {}

LockCaller::~LockCaller() {
  if (!pending_) return;
  std::unique_lock<std::mutex> lock(pending_->mutex);
  pending_->answered.wait_for(lock, std::chrono::seconds(1), [this] { return pending_->reply.has_value(); });
}

bool LockCaller::start(const std::string& command, double value) {
  if (pending_) return false;
  command_ = command;
  pending_ = std::make_shared<Pending>();
  pending_->until = Clock::now() + deadline_;
  std::thread([call = call_, pending = pending_, command, value] {
    LockReply reply;
    try {
      reply = call(command, value);
    } catch (const std::exception& error) {
      reply = {false, error.what()};
    }
    const std::lock_guard<std::mutex> lock(pending->mutex);
    pending->reply = reply;
    pending->answered.notify_all();
  }).detach();
  return true;
}

std::optional<LockReply> LockCaller::poll() {
  if (!pending_) return std::nullopt;
  std::optional<LockReply> reply;
  {
    const std::lock_guard<std::mutex> lock(pending_->mutex);
    reply = pending_->reply;
  }
  if (!reply && Clock::now() >= pending_->until) reply = LockReply{false, "no answer to " + command_};
  if (reply) pending_.reset();
  return reply;
}

}  // namespace viz
