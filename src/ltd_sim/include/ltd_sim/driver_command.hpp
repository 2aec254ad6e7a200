#pragma once

#include <string>

#include "rail_core/sim_time.hpp"

namespace ltd {

/// Pressure of a charged brake pipe, over the atmosphere [Pa]. Source: UIC 540.
inline constexpr double kChargedPipe_Pa = 5.0e5;
/// Brake pressures are in bar in files, all of them over the atmosphere.
inline constexpr double kPascalsPerBar = 1.0e5;

/// What a driver asks of the train; held until the next command.
struct DriverCommand {
  int notch = 0;                              ///< traction, 0 = idle
  int brake_notch = 0;                        ///< dynamic brake, 0 = off; never together with `notch`
  double pipe_pressure_Pa = kChargedPipe_Pa;  ///< asked of the brake pipe at the driver's valve, over the atmosphere
  double independent_brake = 0.0;             ///< locomotives' own air brake, share of its full force, 0..1
  bool emergency = false;                     ///< the pipe is opened wide
  bool sanding = false;                       ///< sand before the locomotives' wheels

  bool operator==(const DriverCommand& o) const {
    return notch == o.notch && brake_notch == o.brake_notch && pipe_pressure_Pa == o.pipe_pressure_Pa &&
           independent_brake == o.independent_brake && emergency == o.emergency && sanding == o.sanding;
  }
};

/// What a driver sees at t_k: the place where the train is and what pulls at it. Forces act on the whole train, +
/// forward.
struct DriverView {
  rail::Nanoseconds t = 0;
  double location_m = 0.0;        ///< chainage of the leading locomotive's CoG
  double speed_mps = 0.0;         ///< of the leading locomotive
  double grade_N = 0.0;           ///< gravity along the track, < 0 uphill
  double resistance_N = 0.0;      ///< Eqs. (5) and (6), <= 0 running forward
  double traction_N = 0.0;        ///< locomotives' forces at the rail in the last step, < 0 braking
  double air_brake_N = 0.0;       ///< wagons' shoes, <= 0 running forward
  double loco_shoes_N = 0.0;      ///< locomotives' shoes: part of traction_N; <= 0 running forward, 0 at a stand
  double speed_limit_mps = 0.0;   ///< lowest under the train
  double pipe_pressure_Pa = 0.0;  ///< in the pipe at the leading vehicle, over the atmosphere
};

}  // namespace ltd
