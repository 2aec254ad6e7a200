#include <ros/ros.h>

#include <csignal>
#include <cstdio>

#include "ltd_program.hpp"

namespace {
volatile std::sig_atomic_t interrupted = 0;
void onInterrupt(int) { interrupted = 1; }
}  // namespace

/// ltd_node: the train; see ltd_program.hpp for its parameters.
int main(int argc, char** argv) {
  std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);  // what is said is seen at once, also through roslaunch
  ros::init(argc, argv, "ltd", ros::init_options::NoSigintHandler);
  ros::master::setRetryTimeout(ros::WallDuration(5.0));
  std::signal(SIGINT, onInterrupt);
  std::signal(SIGTERM, onInterrupt);
  return ltd::runProgram(interrupted);
}
