#include <gtest/gtest.h>

#include <locale>

#include "plots/plot_data.hpp"

namespace viz {
namespace {

PlotData examplePlot() {
  PlotData plot;
  plot.title = "Speed";
  plot.x_title = "Place [km]";
  plot.y_title = "Force [kN], + forward";
  Curve curve;
  curve.name = "a, \"b\"";
  curve.points = {{3.0, 0.123456789}, {3.25, -1e-7}};
  plot.curves = {curve};
  return plot;
}

TEST(PlotCsvTest, HasARowForEveryPoint) {
  EXPECT_EQ(toCsv(examplePlot()),
            "# Speed\n"
            "curve,Place [km],\"Force [kN], + forward\"\n"
            "\"a, \"\"b\"\"\",3,0.123456789\n"
            "\"a, \"\"b\"\"\",3.25,-1e-07\n");
}

TEST(PlotCsvTest, CurvesOfTheRightAxisHaveAColumnOfTheirOwn) {
  PlotData plot = examplePlot();
  plot.right_title = "Notch [-]";
  Curve notch;
  notch.name = "notch";
  notch.right_axis = true;
  notch.points = {{3.0, 8.0}};
  plot.curves[0].name = "speed";
  plot.curves.push_back(notch);
  EXPECT_EQ(toCsv(plot),
            "# Speed\n"
            "curve,Place [km],\"Force [kN], + forward\",Notch [-]\n"
            "speed,3,0.123456789,\n"
            "speed,3.25,-1e-07,\n"
            "notch,3,,8\n");
}

TEST(PlotCsvTest, ALocaleWithDecimalCommasChangesNothing) {
  struct Comma : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
  };
  const std::string before = toCsv(examplePlot());
  const std::locale old = std::locale::global(std::locale(std::locale::classic(), new Comma));
  const std::string after = toCsv(examplePlot());
  std::locale::global(old);
  EXPECT_EQ(after, before);
}

}  // namespace
}  // namespace viz
