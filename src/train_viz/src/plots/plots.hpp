#pragma once

#include <optional>
#include <string>
#include <vector>

#include "plot_data.hpp"
#include "run_data.hpp"

namespace viz {

enum class PlotKind { kTraction, kEnergy, kAdhesion, kCouplers, kSpeed };

/// All plots, in the order in which they are shown.
const std::vector<PlotKind>& allPlots();
/// As layouts and files name it: traction, energy, adhesion, couplers, speed.
std::string nameOf(PlotKind kind);
/// As a tab names it.
std::string titleOf(PlotKind kind);
std::optional<PlotKind> plotNamed(const std::string& name);

/// What a plot shows of a run, in the units people read: km, kN, MJ, km/h. Energy, adhesion and notch are those of the
/// chosen locomotive.
PlotData computePlot(PlotKind kind, const RunData& run);

}  // namespace viz
