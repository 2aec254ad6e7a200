#include <ros/ros.h>

#include <exception>
#include <stdexcept>
#include <string>

#include "train_markers.hpp"

namespace {

/// A parameter of the type of `fallback`; another type is refused.
template <typename Value>
Value readParameter(const ros::NodeHandle& parameters, const std::string& name, Value fallback, const std::string& rule,
                    Value low, Value high) {
  Value value = fallback;
  if (parameters.hasParam(name) && (!parameters.getParam(name, value) || !(value >= low && value <= high)))
    throw std::runtime_error("train_markers: ~" + name + ": " + rule);
  return value;
}

}  // namespace

/// train_markers: shows a run in rviz; see docs/watch.md for its parameters.
int main(int argc, char** argv) {
  ros::init(argc, argv, "train_markers");
  const ros::NodeHandle parameters("~");  // until the end: with the last handle the log is closed, too
  try {
    viz::TrainMarkers::Options options;
    options.locomotive =
        readParameter(parameters, "locomotive", options.locomotive, "must be a whole number from 1, from the head", 1,
                      viz::TrainMarkers::kMostLocomotives);
    options.rate_hz = readParameter(parameters, "rate_hz", options.rate_hz, "must be a number from 1 to 60", 1.0, 60.0);
    const viz::TrainMarkers markers(options);
    ros::spin();
  } catch (const std::exception& error) {
    ROS_FATAL("%s", error.what());
    return 2;
  }
  return 0;
}
