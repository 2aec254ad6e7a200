#include "train_viz/caption.hpp"

#include <algorithm>
#include <cstdio>
#include <numeric>

#include "rail_core/constants.hpp"

namespace viz {

namespace {

constexpr double kNewtonsPerKilonewton = 1000.0;
constexpr double kPascalsPerBar = 1.0e5;

template <typename... Values>
std::string format(const char* pattern, Values... values) {
  char text[128];
  std::snprintf(text, sizeof text, pattern, values...);
  return text;
}

double at(const std::vector<double>& values, std::size_t i) { return i < values.size() ? values[i] : 0.0; }

}  // namespace

std::string computeCaption(const CaptionValues& values, int chosen) {
  const auto i = static_cast<std::size_t>(chosen - 1);
  const double all_N = std::accumulate(values.traction_N.begin(), values.traction_N.end(), 0.0);
  std::string text = format("%.1f km/h at %.3f km\n", rail::kKmphPerMps * values.speed_mps,
                            values.location_m / rail::kMetresPerKilometre);
  text += format("loco %d: notch %g", chosen, at(values.notch, i));
  if (at(values.brake_notch, i) > 0.0) text += format(", brake notch %g", at(values.brake_notch, i));
  text +=
      format(", %.0f kN of %.0f kN", at(values.traction_N, i) / kNewtonsPerKilonewton, all_N / kNewtonsPerKilonewton);
  if (!values.pipe_pressure_Pa.empty() && !values.cylinder_pressure_Pa.empty())
    text += format(
        "\npipe %.2f to %.2f bar, cylinders up to %.2f bar", values.pipe_pressure_Pa.front() / kPascalsPerBar,
        values.pipe_pressure_Pa.back() / kPascalsPerBar,
        *std::max_element(values.cylinder_pressure_Pa.begin(), values.cylinder_pressure_Pa.end()) / kPascalsPerBar);
  return text;
}

}  // namespace viz
