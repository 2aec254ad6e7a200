#pragma once

#include "plot_data.hpp"

namespace viz {

/// The corner of a plot in which a legend hides fewest points: the plot's own as long as none is hidden there, else the
/// emptiest, the plot's own if several are. The plot's frame holds all points and the value 0 of the axes of values.
LegendCorner emptiestCorner(const PlotData& plot);

}  // namespace viz
