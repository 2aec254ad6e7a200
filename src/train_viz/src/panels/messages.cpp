#include "messages.hpp"

namespace viz {

TrainSample fromMsg(const train_msgs::TrainState& msg) {
  TrainSample sample;
  sample.time_s = msg.header.stamp.toSec();
  sample.place_m = msg.location;
  sample.speed_mps = msg.speed;
  sample.speed_limit_mps = msg.speed_limit;
  sample.sanding = msg.sanding != 0;
  sample.notch = msg.notch;
  sample.brake_notch = msg.brake_notch;
  sample.traction_N = msg.traction;
  sample.coupler_N = msg.coupler_force;
  return sample;
}

EnergySample fromMsg(const train_msgs::TrainEnergy& msg) {
  EnergySample sample;
  sample.time_s = msg.header.stamp.toSec();
  sample.rail_J = msg.loco_energy_rail;
  sample.rim_J = msg.loco_energy_rim;
  sample.recovered_J = msg.loco_recovered_rim;
  return sample;
}

AdhesionSample fromMsg(const train_msgs::Adhesion& msg) {
  AdhesionSample sample;
  sample.time_s = msg.header.stamp.toSec();
  sample.place_m = msg.location;
  sample.speed_mps = msg.speed;
  for (const train_msgs::AxleAdhesion& axle : msg.axles)
    sample.axles.push_back({axle.creep, axle.adhesion, axle.normal_force});
  return sample;
}

}  // namespace viz
