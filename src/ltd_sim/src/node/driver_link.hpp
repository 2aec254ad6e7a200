#pragma once

#include <ros/ros.h>
#include <train_msgs/DriverCommand.h>
#include <train_msgs/DriverView.h>

#include <functional>
#include <optional>
#include <string>

#include "loco_dynamics/node/immediate_queue.hpp"
#include "ltd_sim/driver_port.hpp"

namespace ltd {

/// A driver that is a node of his own: asked on /train/driver_view (latched, and asked again every 100 ms of wall
/// time), heard on /train/driver. Only an answer that names this run and the step asked for counts. Not thread-safe but
/// for the topics themselves.
class DriverLink : public DriverPort {
 public:
  using Receive = std::function<void(const train_msgs::DriverCommand&)>;
  /// @param first_deadline_s  for the first answer [s of wall time]: his node may start later than the train
  DriverLink(std::uint64_t run_id, double answer_deadline_s, double first_deadline_s);
  ~DriverLink() override { close(); }

  /// From now on answers are handed to `receive`, in another thread, until close().
  void open(Receive receive);
  void close();

  void ask(std::uint64_t step, const DriverView& view) override;
  const DriverCommand* answer() override;
  void refuse(const std::string& why) override;
  double deadline_s() const override;
  bool silent() override;

  /// Takes what came in. @return empty, or why it does not count
  std::string take(const train_msgs::DriverCommand& msg);
  /// In words, if his last answer to this question was refused; else empty.
  std::string refusal() const;
  /// Asks again, if it is time.
  void tick();
  /// In words, if he has kept the run waiting for longer than that; else empty.
  std::string waitsFor(double patience_s) const;

 private:
  double waited_s() const;

  std::uint64_t run_id_;
  double answer_deadline_s_, first_deadline_s_;
  bool asked_ = false, accepted_once_ = false;
  double asked_at_s_ = 0.0, sent_at_s_ = 0.0;  ///< wall time
  std::optional<DriverCommand> answer_;
  std::string refused_;  ///< why the last answer to this question did not count
  train_msgs::DriverView question_;

  loco::ImmediateQueue queue_;
  ros::NodeHandle node_;
  Receive receive_;
  ros::Publisher publisher_;
  ros::Subscriber subscriber_;
};

}  // namespace ltd
