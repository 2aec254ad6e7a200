#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace viz {

struct LockReply {
  bool accepted = false;
  std::string message;
};

/// Calls a service in a thread of its own, so that nobody who draws has to wait. One call at a time.
class LockCaller {
 public:
  using Call = std::function<LockReply(const std::string& command, double value)>;
  /// @param call      must own what it uses: it may still run after this object is gone
  /// @param deadline  wall time after which an answer is waited for no longer
  explicit LockCaller(Call call, std::chrono::milliseconds deadline = std::chrono::seconds(5));
  /// Waits for a call under way, for a second at most.
  ~LockCaller();
  LockCaller(const LockCaller&) = delete;
  LockCaller& operator=(const LockCaller&) = delete;

  /// @return false if a call is under way: then nothing is called
  bool start(const std::string& command, double value);
  bool busy() const { return pending_ != nullptr; }
  /// The answer to the call under way, once; returns at once. When its deadline has passed, an answer that says so.
  std::optional<LockReply> poll();

 private:
  struct Pending;
  Call call_;
  std::chrono::milliseconds deadline_;
  std::string command_;
  std::shared_ptr<Pending> pending_;  ///< shared with the thread
};

}  // namespace viz
