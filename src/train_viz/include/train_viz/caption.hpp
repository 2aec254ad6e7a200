#pragma once

#include <string>
#include <vector>

namespace viz {

/// What the text above the train says.
struct CaptionValues {
  double speed_mps = 0.0;
  double location_m = 0.0;
  std::vector<double> notch;                 ///< per locomotive
  std::vector<double> brake_notch;           ///< per locomotive, of the dynamic brake
  std::vector<double> traction_N;            ///< per locomotive
  std::vector<double> pipe_pressure_Pa;      ///< per vehicle; empty without an air brake
  std::vector<double> cylinder_pressure_Pa;  ///< per vehicle; empty without an air brake
};

/// Three lines: speed and place of the leading locomotive; notch and traction of the chosen one, and of all; pressures
/// in the brake pipe at head and end and the highest in a cylinder.
/// @param chosen  locomotive, from 1
std::string computeCaption(const CaptionValues& values, int chosen);

}  // namespace viz
