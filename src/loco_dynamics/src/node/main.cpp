#include <ros/ros.h>

#include <cstdio>
#include <exception>

#include "loco_node.hpp"

/// loco_node: one locomotive of the train; see loco_node.hpp for topics and parameters.
int main(int argc, char** argv) {
  std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);  // what is said is seen at once, also through roslaunch
  ros::init(argc, argv, "loco");
  ros::master::setRetryTimeout(ros::WallDuration(5.0));
  try {
    loco::LocoNode node;
    ros::AsyncSpinner spinner(1);
    spinner.start();
    return node.run();
  } catch (const std::exception& error) {
    ROS_FATAL("%s", error.what());
    return 2;
  }
}
