#include "plots.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace viz {

namespace {

constexpr double kKilo = 1e3, kMega = 1e6, kKilometresPerHour = 3.6;
constexpr char kPlace[] = "Place [km]";  // of the leading locomotive

std::vector<Point> scaled(const DecimatedSeries& series, double x_unit, double y_unit) {
  std::vector<Point> points = series.points();
  for (Point& point : points) point = {point.x / x_unit, point.y / y_unit};
  return points;
}

std::string locoName(std::size_t i) { return "locomotive " + std::to_string(i + 1); }

std::string format(const char* pattern, double value) {
  char text[64];
  std::snprintf(text, sizeof text, pattern, value);
  return text;
}

/// The chosen locomotive's series; null if nothing is known of it.
const LocoSeries* chosen(const RunData& run) {
  const auto i = static_cast<std::size_t>(run.locomotive() - 1);
  return run.locomotive() >= 1 && i < run.locomotives().size() ? &run.locomotives()[i] : nullptr;
}

std::string missingLocomotive(const RunData& run) {
  if (run.locomotives().empty()) return "waits for the train";
  return "the train has no locomotive " + std::to_string(run.locomotive());
}

PlotData computeTraction(const RunData& run) {
  PlotData plot{"Traction at the rail",     kPlace, "Force [kN], + forward", "", 0.01, 10.0, "",
                LegendCorner::kBottomRight, {}};
  for (std::size_t i = 0; i < run.locomotives().size(); ++i) {
    // equal locomotives lie on each other: the first ones are wider, so that all are seen
    const double width = std::min(2.0 + 2.0 * static_cast<double>(run.locomotives().size() - 1 - i), 8.0);
    plot.curves.push_back({locoName(i), CurveStyle::kLine, static_cast<int>(i), false, true,
                           scaled(run.locomotives()[i].traction_N, kKilo, kKilo), width});
  }
  if (plot.empty()) plot.remark = "waits for the train";
  return plot;
}

PlotData computeEnergy(const RunData& run) {
  PlotData plot{"Energy of " + locoName(static_cast<std::size_t>(run.locomotive() - 1)),
                kPlace,
                "Energy [MJ]",
                "",
                0.01,
                1.0,
                "",
                LegendCorner::kTopLeft,
                {}};
  const LocoSeries* loco = chosen(run);
  if (loco == nullptr) {
    plot.remark = missingLocomotive(run);
    return plot;
  }
  plot.curves.push_back(
      {"at the rail, Eq. (4)", CurveStyle::kLine, 0, false, true, scaled(loco->rail_J, kKilo, kMega)});
  plot.curves.push_back({"at the wheel rims", CurveStyle::kDashes, 1, false, true, scaled(loco->rim_J, kKilo, kMega)});
  plot.curves.push_back(
      {"recovered at the rims", CurveStyle::kLine, 2, false, true, scaled(loco->recovered_J, kKilo, kMega)});
  if (plot.empty()) plot.remark = "waits for the energies";
  return plot;
}

/// The chosen locomotive's creep curve behind its points.
void addCreepCurve(const RunData& run, PlotData& plot) {
  const AdhesionSample& now = *run.adhesion();
  if (!run.creepCurve() || now.axles.empty()) {
    plot.remark = run.whyNoCurve();
    return;
  }
  double load_N = 0.0, least = 0.0, largest = 0.02;  // chosen: the top of any curve lies within 2 %
  for (const AxleSample& axle : now.axles) load_N += axle.normal_N / static_cast<double>(now.axles.size());
  for (const Curve& curve : plot.curves) {
    for (const Point& point : curve.points) {
      least = std::min(least, point.x);
      largest = std::max(largest, point.x);
    }
  }
  const bool sanding = run.train() && run.train()->sanding;
  const CreepCurve::Situation situation{load_N, now.speed_mps, now.place_m, sanding};
  plot.curves.insert(plot.curves.begin(),
                     {sanding ? "creep curve, sanded" : "creep curve", CurveStyle::kBackground, 0, false, true,
                      run.creepCurve()->computePoints(least, largest, situation), 4.0});
}

PlotData computeAdhesion(const RunData& run) {
  PlotData plot{"Adhesion of " + locoName(static_cast<std::size_t>(run.locomotive() - 1)),
                "Creep [-], + driving",
                "Adhesion [-], + driving",
                "",
                0.005,
                0.05,
                "",
                LegendCorner::kBottomRight,
                {}};
  if (!run.adhesion()) {
    plot.remark = run.whyNoCurve().empty() ? "waits for the locomotive's adhesion" : run.whyNoCurve();
    return plot;
  }
  plot.title += format(" at %.1f km/h", run.adhesion()->speed_mps * kKilometresPerHour);
  for (std::size_t i = 0; i < run.axles().size(); ++i)
    plot.curves.push_back({"axle " + std::to_string(i + 1) + ", passed", CurveStyle::kDots, static_cast<int>(i), false,
                           false, run.axles()[i].points()});
  for (std::size_t i = 0; i < run.adhesion()->axles.size(); ++i) {
    const AxleSample& axle = run.adhesion()->axles[i];
    plot.curves.push_back({"axle " + std::to_string(i + 1),
                           CurveStyle::kMarks,
                           static_cast<int>(i),
                           false,
                           true,
                           {{axle.creep, axle.adhesion}}});
  }
  addCreepCurve(run, plot);
  return plot;
}

PlotData computeCouplers(const RunData& run) {
  PlotData plot{"In-train forces",
                "Coupler from the head [-]",
                "Force [kN], draft +",
                "",
                4.0,
                10.0,
                "",
                LegendCorner::kTopRight,
                {}};
  if (!run.train() || run.couplers().empty()) {
    plot.remark = run.train() ? "a single vehicle has no couplers" : "waits for the train";
    return plot;
  }
  Curve now{"now", CurveStyle::kBars, 0, false, true, {}};
  Curve draft{"largest draft so far", CurveStyle::kDashes, 1, false, true, {}};
  Curve buff{"largest buff so far", CurveStyle::kDashes, 2, false, true, {}};
  for (std::size_t i = 0; i < run.couplers().size(); ++i) {
    const double number = static_cast<double>(i + 1);
    now.points.push_back({number, run.train()->coupler_N[i] / kKilo});
    draft.points.push_back({number, run.couplers()[i].largest_N / kKilo});
    buff.points.push_back({number, run.couplers()[i].least_N / kKilo});
  }
  plot.title += format(" at %.3f km", run.train()->place_m / kKilo);
  plot.curves = {now, draft, buff};
  return plot;
}

PlotData computeSpeed(const RunData& run) {
  PlotData plot{"Speed and notch", kPlace, "Speed [km/h]", "Notch [-]", 0.01, 5.0, "", LegendCorner::kBottomRight, {}};
  const double per_hour = 1.0 / kKilometresPerHour;
  plot.curves.push_back({"speed", CurveStyle::kLine, 0, false, true, scaled(run.speed(), kKilo, per_hour)});
  plot.curves.push_back(
      {"speed limit", CurveStyle::kDashes, 1, false, true, scaled(run.speedLimit(), kKilo, per_hour)});
  if (const LocoSeries* loco = chosen(run)) {
    plot.title += " of " + locoName(static_cast<std::size_t>(run.locomotive() - 1));
    plot.curves.push_back({"notch", CurveStyle::kSteps, 2, true, true, scaled(loco->notch, kKilo, 1.0)});
    plot.curves.push_back({"brake notch", CurveStyle::kSteps, 3, true, true, scaled(loco->brake_notch, kKilo, 1.0)});
  } else {
    plot.remark = missingLocomotive(run);
  }
  return plot;
}

struct Entry {
  PlotKind kind;
  const char* name;
  const char* title;
  PlotData (*compute)(const RunData&);
};
const std::vector<Entry>& entries() {
  static const std::vector<Entry> all = {{PlotKind::kTraction, "traction", "Traction", computeTraction},
                                         {PlotKind::kEnergy, "energy", "Energy", computeEnergy},
                                         {PlotKind::kAdhesion, "adhesion", "Adhesion", computeAdhesion},
                                         {PlotKind::kCouplers, "couplers", "Couplers", computeCouplers},
                                         {PlotKind::kSpeed, "speed", "Speed", computeSpeed}};
  return all;
}
const Entry& entryOf(PlotKind kind) {
  return *std::find_if(entries().begin(), entries().end(), [kind](const Entry& entry) { return entry.kind == kind; });
}

}  // namespace

const std::vector<PlotKind>& allPlots() {
  static const std::vector<PlotKind> kinds = [] {
    std::vector<PlotKind> all;
    for (const Entry& entry : entries()) all.push_back(entry.kind);
    return all;
  }();
  return kinds;
}

std::string nameOf(PlotKind kind) { return entryOf(kind).name; }

std::string titleOf(PlotKind kind) { return entryOf(kind).title; }

std::optional<PlotKind> plotNamed(const std::string& name) {
  for (const Entry& entry : entries())
    if (name == entry.name) return entry.kind;
  return std::nullopt;
}

PlotData computePlot(PlotKind kind, const RunData& run) { return entryOf(kind).compute(run); }

}  // namespace viz
