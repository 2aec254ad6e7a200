#include "ltd_sim/air_brake.hpp"

#include <algorithm>

namespace ltd {

namespace {

/// Of each vehicle's CoG, backwards from that of the leading locomotive, where the driver's valve is taken to be.
std::vector<double> placesOf(const TrainModel& train) {
  std::vector<double> place_m(train.vehicles.size(), 0.0);
  for (std::size_t i = 1; i < place_m.size(); ++i) place_m[i] = place_m[i - 1] + train.coupler_distance_m[i - 1];
  if (train.locomotives.empty()) return place_m;
  const double valve_m = place_m[train.locomotives.front().vehicle];
  for (double& place : place_m) place -= valve_m;
  return place_m;
}

/// Of the first locomotive of each notch group but the leading locomotive's.
std::vector<double> remoteValves(const TrainModel& train, const std::vector<double>& place_m) {
  std::vector<double> remote_m;
  std::vector<bool> known(train.notch_groups.size(), false);
  for (const LocoUnit& unit : train.locomotives) {
    if (!known[unit.notch_group] && &unit != &train.locomotives.front()) remote_m.push_back(place_m[unit.vehicle]);
    known[unit.notch_group] = true;
  }
  return remote_m;
}

bool anyBrake(const TrainModel& train) {
  return std::any_of(train.brakes.begin(), train.brakes.end(), [](const VehicleBrake& b) { return b.present(); });
}

bool sameForBrake(const DriverCommand& a, const DriverCommand& b) {
  return a.pipe_pressure_Pa == b.pipe_pressure_Pa && a.independent_brake == b.independent_brake &&
         a.emergency == b.emergency;
}

}  // namespace

AirBrake AirBrake::read(rail::YamlReader reader, const TrainModel& train) {
  AirBrake result;
  reader.text("name");
  const bool electronic = reader.choice("control", {"pneumatic", "electronic"}) == "electronic";
  const bool applied = reader.choice("start", {"released", "full_service"}) == "full_service";
  const BrakePipe::Parameters pipe = BrakePipe::read(reader.map("pipe"), electronic);
  result.distributor_ = Distributor::read(reader.map("valve"), kChargedPipe_Pa - pipe.full_service_Pa, electronic);
  const BrakeCylinder cylinder = BrakeCylinder::read(reader.map("cylinder"));
  if (reader.present() && !train.vehicles.empty() && !anyBrake(train))
    reader.refuse("", "no vehicle of the train has a brake");
  const std::vector<double> place_m = placesOf(train);
  const std::vector<double> remote_m = pipe.remote_valves ? remoteValves(train, place_m) : std::vector<double>();
  if (pipe.remote_valves && !train.vehicles.empty() && remote_m.empty())
    reader.refuse("pipe.remote_valves", "the train has no locomotives of a second notch_group");
  reader.finish();
  result.pipe_ = BrakePipe(pipe, place_m, remote_m);
  result.start_Pa_ = applied ? pipe.full_service_Pa : kChargedPipe_Pa;
  result.vehicles_.resize(train.vehicles.size());
  for (std::size_t i = 0; i < result.vehicles_.size(); ++i) {
    if (i < train.brakes.size()) result.vehicles_[i].brake = train.brakes[i];
    result.vehicles_[i].cylinder = result.vehicles_[i].brake.cylinder.value_or(cylinder);
  }
  for (const LocoUnit& unit : train.locomotives) result.vehicles_[unit.vehicle].locomotive = true;
  return result;
}

AirBrake::State AirBrake::stateAtRest(double pipe_Pa) const {
  State state;
  if (!present()) return state;
  state.pipe = pipe_.initialState(pipe_Pa);
  state.command.pipe_pressure_Pa = pipe_Pa;
  state.distributors.assign(vehicles_.size(), distributor_.initialState(pipe_Pa));
  state.cylinder_Pa.assign(vehicles_.size(), 0.0);
  for (std::size_t i = 0; i < vehicles_.size(); ++i) {
    const BrakedVehicle& v = vehicles_[i];
    if (v.brake.present() && pipe_Pa < kChargedPipe_Pa) state.cylinder_Pa[i] = v.cylinder.full();
  }
  return state;
}

void AirBrake::step(const DriverCommand& command, rail::Nanoseconds H, State& state) const {
  if (!present()) return;
  const bool same = sameForBrake(command, state.command);
  state.command = command;
  // The whole history is one value then, and every vehicle has had it: nothing can move.
  if (same && state.quiet_steps > state.pipe.history.size()) return;
  const double step_s = rail::toSeconds(H);
  bool changed = pipe_.step(command, step_s, state.pipe);
  for (std::size_t i = 0; i < vehicles_.size(); ++i) changed = stepVehicle(i, command, step_s, state) || changed;
  state.quiet_steps = changed || !same ? 0 : state.quiet_steps + 1;
}

bool AirBrake::stepVehicle(std::size_t i, const DriverCommand& command, double step_s, State& state) const {
  const BrakedVehicle& v = vehicles_[i];
  if (!v.brake.present()) return false;
  const bool emergency = state.pipe.emergency[i] != 0;
  const double reservoir_Pa = state.distributors[i].reservoir_Pa;
  double share = distributor_.step(state.pipe.pipe_Pa[i], emergency, step_s, state.distributors[i]);
  if (v.locomotive) share = std::max(share, command.independent_brake);
  const double before_Pa = state.cylinder_Pa[i];
  state.cylinder_Pa[i] = v.cylinder.next(before_Pa, share * v.cylinder.full(), emergency, step_s);
  return state.cylinder_Pa[i] != before_Pa || state.distributors[i].reservoir_Pa != reservoir_Pa;
}

double AirBrake::shoeForce(std::size_t vehicle, double v_mps, const State& state) const {
  if (!present() || state.cylinder_Pa[vehicle] <= 0.0) return 0.0;
  const BrakedVehicle& v = vehicles_[vehicle];
  return v.brake.largestRetardation(state.cylinder_Pa[vehicle] / v.cylinder.full(), v_mps);
}

double AirBrake::pipePressure(std::size_t vehicle, const State& state) const {
  return present() ? state.pipe.pipe_Pa[vehicle] : kChargedPipe_Pa;
}

double AirBrake::cylinderPressure(std::size_t vehicle, const State& state) const {
  return present() ? state.cylinder_Pa[vehicle] : 0.0;
}

}  // namespace ltd
