#pragma once

#include <string>
#include <vector>

#include "decimated_series.hpp"

namespace viz {

enum class CurveStyle {
  kLine,
  kDashes,
  kBackground,  ///< a wide grey line that lies under the others
  kDots,        ///< small points that nothing joins
  kMarks,       ///< large ones
  kSteps,       ///< holds until the next point
  kBars         ///< from 0 to the point
};

struct Curve {
  std::string name;
  CurveStyle style = CurveStyle::kLine;
  int colour = 0;           ///< number of a colour; equal numbers, equal colours
  bool right_axis = false;  ///< measured on the axis at the right
  bool in_legend = true;
  std::vector<Point> points;
  double width = 2.0;  ///< of a line, in pixels
};

enum class LegendCorner { kTopLeft, kTopRight, kBottomRight, kBottomLeft };

/// All that is seen of a plot: what draws it needs to know nothing of trains. Titles carry their units.
struct PlotData {
  std::string title, x_title, y_title;
  std::string right_title;                           ///< empty: no axis at the right
  double least_x_span = 0.0, least_y_span = 0.0;     ///< so that noise does not fill the frame
  std::string remark;                                ///< why something is missing; empty if nothing is
  LegendCorner legend = LegendCorner::kBottomRight;  ///< where it hides nothing in most runs
  std::vector<Curve> curves;

  bool empty() const {
    for (const Curve& curve : curves)
      if (!curve.points.empty()) return false;
    return true;
  }
};

/// The plot's points as text, a row a point: curve, x, y; curves of the right axis have their value in a fourth column.
/// Numbers have nine digits and a decimal point whatever the locale; the title is in the first line after a #.
std::string toCsv(const PlotData& plot);

}  // namespace viz
