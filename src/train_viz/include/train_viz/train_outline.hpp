#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "rail_core/track.hpp"

namespace viz {

/// What one bogie shows.
struct BogieOutline {
  double x_m = 0.0;             ///< ahead of the vehicle's CoG
  std::vector<double> axles_m;  ///< ahead of the vehicle's CoG, from the front
};

/// What one vehicle shows.
struct VehicleOutline {
  double length_m = 0.0;          ///< over couplers
  std::optional<int> locomotive;  ///< its number from 1 at the head; none for a wagon
  double wheel_radius_m = 0.0;
  std::vector<BogieOutline> bogies;

  std::vector<double> axles_m() const;  ///< of all bogies, from the front
};

/// The train and the line of one run, as far as they can be seen. Constant.
struct TrainOutline {
  rail::Track track;
  std::vector<VehicleOutline> vehicles;  ///< from the head
  std::vector<std::size_t> locomotives;  ///< index in `vehicles`, per locomotive
  std::string name;

  /// Reads the resolved scenario, as /train/configuration carries it.
  /// @throws rail::ConfigError with all problems found
  static TrainOutline read(const std::string& resolved);
};

}  // namespace viz
