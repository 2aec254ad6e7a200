#pragma once

#include <string>
#include <vector>

#include "ltd_sim/air_brake.hpp"
#include "train_fixtures.hpp"

namespace fixtures {

constexpr double kBar = 1e5;
constexpr rail::Nanoseconds kBrakeStep = 2000000;  // 2 ms

/// What may differ between the brakes of the tests.
struct BrakeText {
  std::string control = "pneumatic";
  std::string start = "released";
  std::string pipe =
      "{full_service_bar: 3.5, service_exhaust_bar_per_s: 0.25, emergency_exhaust_bar_per_s: 2.5, "
      "charging_bar_per_s: 0.2, charging_length_m: 500, service_wave_mps: 200, emergency_wave_mps: 250, "
      "remote_valves: false}";
  std::string valve = "{release: graduated, first_reduction_bar: 0.4, full_release_reduction_bar: 0.15}";
  std::string cylinder = "{position: G, full_bar: 3.8, fill_time_s: 24, emergency_fill_time_s: 18, release_time_s: 52}";

  std::string text() const {
    return "{name: test, control: " + control + ", start: " + start + ", pipe: " + pipe + ", valve: " + valve +
           ", cylinder: " + cylinder + "}";
  }
};

inline BrakeText electronicBrake(const std::string& delay_s = "0.2") {
  BrakeText text;
  text.control = "electronic";
  text.pipe = "{full_service_bar: 3.5, delay_s: " + delay_s + "}";
  return text;
}

/// Eight shoes of constant friction 0.36 that press with a tenth of the weight.
inline ltd::VehicleBrake tenthOfWeight(const rail::Vehicle& vehicle) {
  ltd::VehicleBrake brake;
  brake.shoe_force_N = 0.1 * vehicle.mass_kg * rail::kGravity_mps2;
  brake.shoes = 8;
  brake.friction = ltd::ShoeFriction::constant(0.36);
  return brake;
}

/// 108 braked vehicles of 120 t, the first one a locomotive; 1641 m from its CoG to the last one's.
inline ltd::TrainModel brakedTrain() {
  rail::Vehicle vehicle = freeVehicle(120e3);
  vehicle.length_m = 1641.0 / 107.0;
  ltd::TrainModel train = makeTrain(std::vector<rail::Vehicle>(108, vehicle), {0}, draftGear());
  for (const rail::Vehicle& v : train.vehicles) train.brakes.push_back(tenthOfWeight(v));
  return train;
}

inline ltd::AirBrake makeAirBrake(const BrakeText& text, const ltd::TrainModel& train) {
  return readMap(text.text(), [&](rail::YamlReader reader) { return ltd::AirBrake::read(reader, train); });
}

inline ltd::DriverCommand pipeAt(double bar) {
  ltd::DriverCommand command;
  command.pipe_pressure_Pa = bar * kBar;
  return command;
}
inline ltd::DriverCommand emergencyCommand() {
  ltd::DriverCommand command = pipeAt(0.0);
  command.emergency = true;
  return command;
}

/// A brake and its state, stepped under commands.
class BrakeRig {
 public:
  explicit BrakeRig(const BrakeText& text = {}, const ltd::TrainModel& train_model = brakedTrain())
      : train(train_model), brake(makeAirBrake(text, train)), state(brake.initialState()) {}

  void step(const ltd::DriverCommand& command, rail::Nanoseconds H = kBrakeStep) {
    brake.step(command, H, state);
    t += H;
  }
  void run(const ltd::DriverCommand& command, double seconds, rail::Nanoseconds H = kBrakeStep) {
    const rail::Nanoseconds end = t + rail::wholeNanoseconds(seconds).value();
    while (t < end) step(command, H);
  }
  /// Runs until the condition holds. @return seconds that it took, < 0 if not within 300 s
  template <typename Condition>
  double runUntil(const ltd::DriverCommand& command, Condition condition) {
    const rail::Nanoseconds begin = t;
    while (t < begin + 300 * rail::kNanosecondsPerSecond) {
      step(command);
      if (condition()) return rail::toSeconds(t - begin);
    }
    return -1.0;
  }
  double pipe(std::size_t i) const { return brake.pipePressure(i, state) / kBar; }
  double cylinder(std::size_t i) const { return brake.cylinderPressure(i, state) / kBar; }
  double force(std::size_t i, double v_mps = 10.0) const { return brake.shoeForce(i, v_mps, state); }

  const ltd::TrainModel train;
  const ltd::AirBrake brake;
  ltd::AirBrake::State state;
  rail::Nanoseconds t = 0;
};

}  // namespace fixtures
