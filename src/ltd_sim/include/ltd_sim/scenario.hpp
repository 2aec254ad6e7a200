#pragma once

#include <limits>
#include <string>
#include <vector>

#include "ltd_sim/air_brake.hpp"
#include "ltd_sim/driver.hpp"
#include "ltd_sim/train_model.hpp"
#include "rail_core/document.hpp"
#include "rail_core/sim_time.hpp"
#include "rail_core/track.hpp"

namespace ltd {

/// When a run ends and where it starts. Places are those of the leading locomotive's CoG.
struct RunLimits {
  double start_location_m = 0.0;
  double start_speed_mps = 0.0;
  double end_location_m = 0.0;
  rail::Nanoseconds end_time = 0;
  double stall_speed_mps = 0.0;           ///< a stall: traction on and slower than this ...
  rail::Nanoseconds stall_time = 0;       ///< ... for this long
  rail::Nanoseconds standstill_time = 0;  ///< ends when the train, having moved, has stood for so long; 0: does not
  double runaway_margin_mps = std::numeric_limits<double>::infinity();  ///< fails that far above the line's limit
};

/// How the lock waits, in wall time.
struct LockLimits {
  double join_deadline_s = 0.0;
  double answer_deadline_s = 0.0;
  double synchronisation_tolerance_mps = 0.0;  ///< largest difference of a locomotive's speed from LTD's
};

struct OutputOptions {
  std::vector<double> report_locations_m;    ///< rising
  std::vector<double> section_boundaries_m;  ///< rising; energies are given between neighbours
  rail::Nanoseconds timeseries_interval = 0;
  rail::Nanoseconds telemetry_interval = 0;
  bool record_exchange = false;  ///< every LocoForce and LocoTraction into the bag
};

/// A run as the user describes it, checked as a whole. Constant.
struct Scenario {
  std::string file;
  std::string name;
  std::string locomotive_model;
  bool rotary_inertia = false;
  TrainModel train;
  rail::Track track;
  Driver driver;
  AirBrake air_brake;
  RunLimits run;
  LockLimits lock;
  OutputOptions output;
  rail::Nanoseconds macro_step = 0;  ///< H
  rail::Nanoseconds micro_step = 0;  ///< h, divides H
  rail::Document document;           ///< resolved

  /// Reads the scenario file and everything that it names.
  /// @throws rail::ConfigError with all problems found.
  static Scenario load(const std::string& path, const std::vector<rail::Override>& overrides);
};

}  // namespace ltd
