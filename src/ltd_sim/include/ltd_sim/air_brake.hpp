#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "ltd_sim/brake_cylinder.hpp"
#include "ltd_sim/brake_pipe.hpp"
#include "ltd_sim/distributor.hpp"
#include "ltd_sim/driver_command.hpp"
#include "ltd_sim/train_model.hpp"
#include "rail_core/sim_time.hpp"

namespace ltd {

/// The train's air brake from the driver's valve to the shoes; constant. Default-constructed: none, no force.
/// The law of each part stands in brake_pipe.hpp, distributor.hpp, brake_cylinder.hpp, vehicle_brake.hpp and
/// docs/brakes.md. The independent brake fills the cylinders of all locomotives at once; a locomotive's cylinder takes
/// the larger of the two.
class AirBrake {
 public:
  /// All memory of the brake.
  struct State {
    BrakePipe::State pipe;
    std::vector<Distributor::State> distributors;  ///< per vehicle
    std::vector<double> cylinder_Pa;               ///< per vehicle
    DriverCommand command;                         ///< of the last step
    std::size_t quiet_steps = 0;                   ///< steps with the same command in which nothing moved
  };

  AirBrake() = default;

  /// YAML `air_brake`: name, control (pneumatic, electronic), start (released, full_service), pipe, valve, cylinder.
  /// Vehicles with their own cylinder (see VehicleBrake) have that one.
  static AirBrake read(rail::YamlReader reader, const TrainModel& train);

  bool present() const { return !vehicles_.empty(); }

  /// Pressure in the pipe that asks for full service, over the atmosphere [Pa].
  double fullServicePressure() const { return pipe_.parameters().full_service_Pa; }

  /// Reduction of the pipe from which the vehicles' valves apply [Pa].
  double firstReduction() const { return distributor_.firstReduction(); }

  /// Graduated release: at a smaller reduction of the pipe the brakes are off [Pa]; direct: 0.
  double fullReleaseReduction() const { return distributor_.fullReleaseReduction(); }

  State initialState() const { return stateAtRest(start_Pa_); }

  /// At rest with the pipe at this pressure, reached from the charged one with full reservoirs; cylinders are full if
  /// it is not charged, so it must be that of full service then.
  State stateAtRest(double pipe_Pa) const;

  /// Advances the brake by H with the command held. H must be the same in all steps. Allocates in the first step only.
  void step(const DriverCommand& command, rail::Nanoseconds H, State& state) const;

  /// Largest force with which the shoes of a vehicle can retard it at this speed [N], >= 0.
  double shoeForce(std::size_t vehicle, double v_mps, const State& state) const;

  /// In the pipe at a vehicle, over the atmosphere [Pa]; of an electronic brake: what the vehicle is told.
  double pipePressure(std::size_t vehicle, const State& state) const;

  /// In a vehicle's brake cylinder, over the atmosphere [Pa]; 0 without a brake.
  double cylinderPressure(std::size_t vehicle, const State& state) const;

 private:
  struct BrakedVehicle {
    VehicleBrake brake;
    BrakeCylinder cylinder;
    bool locomotive = false;
  };
  bool stepVehicle(std::size_t i, const DriverCommand& command, double step_s, State& state) const;

  std::vector<BrakedVehicle> vehicles_;
  BrakePipe pipe_;
  Distributor distributor_;
  double start_Pa_ = kChargedPipe_Pa;  ///< of the pipe
};

}  // namespace ltd
