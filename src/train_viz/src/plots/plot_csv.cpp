#include <locale>
#include <sstream>

#include "plot_data.hpp"

namespace viz {

namespace {

/// A field as RFC 4180 wants it.
std::string field(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + '"';
}

}  // namespace

std::string toCsv(const PlotData& plot) {
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out.precision(9);
  const bool two_axes = !plot.right_title.empty();
  out << "# " << plot.title << '\n' << "curve," << field(plot.x_title) << ',' << field(plot.y_title);
  if (two_axes) out << ',' << field(plot.right_title);
  out << '\n';
  for (const Curve& curve : plot.curves) {
    const std::string name = field(curve.name);
    for (const Point& point : curve.points) {
      out << name << ',' << point.x << ',';
      if (!curve.right_axis) out << point.y;
      if (two_axes) out << ',';
      if (curve.right_axis) out << point.y;
      out << '\n';
    }
  }
  return out.str();
}

}  // namespace viz
