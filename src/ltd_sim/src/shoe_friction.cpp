#include "ltd_sim/shoe_friction.hpp"

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "rail_core/constants.hpp"

namespace ltd {

namespace {

ShoeFriction readTable(rail::YamlReader& reader) {
  std::vector<double> speed_mps, mu;
  const std::vector<std::vector<double>> points = reader.rows("points", 2);
  if (points.empty()) {
    if (reader.has("points")) reader.refuse("points", "must have at least one point");
    return ShoeFriction::constant(0.0);
  }
  bool good = true;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::string key = "points." + std::to_string(i);
    if (points[i][0] < 0.0) reader.refuse(key, "speed in km/h must be >= 0"), good = false;
    if (points[i][1] <= 0.0 || points[i][1] > 1.0) reader.refuse(key, "mu must be > 0 and <= 1"), good = false;
    speed_mps.push_back(points[i][0] / rail::kKmphPerMps);
    mu.push_back(points[i][1]);
  }
  const std::string rule = rail::risingRule(speed_mps);
  if (!rule.empty()) reader.refuse("points", "speeds " + rule + " (in m/s)"), good = false;
  return good ? ShoeFriction::table(std::move(speed_mps), std::move(mu)) : ShoeFriction::constant(0.0);
}

}  // namespace

ShoeFriction ShoeFriction::constant(double mu) {
  ShoeFriction friction;
  friction.mu_ = mu;
  return friction;
}

ShoeFriction ShoeFriction::karwatzki() {
  ShoeFriction friction;
  friction.law_ = Law::kKarwatzki;
  return friction;
}

ShoeFriction ShoeFriction::table(std::vector<double> speed_mps, std::vector<double> mu) {
  ShoeFriction friction;
  friction.law_ = Law::kTable;
  friction.table_ = rail::LookupTable(std::move(speed_mps), std::move(mu));
  return friction;
}

ShoeFriction ShoeFriction::read(rail::YamlReader reader) {
  const std::string law = reader.choice("law", {"constant", "karwatzki", "table"});
  ShoeFriction friction;
  if (law == "constant") friction = constant(reader.number("mu", rail::aboveUpTo(0.0, 1.0)));
  if (law == "karwatzki") friction = karwatzki();
  if (law == "table") friction = readTable(reader);
  reader.finish();
  return friction;
}

double ShoeFriction::coefficient(double shoe_force_N, double v_mps) const {
  if (law_ == Law::kConstant) return mu_;
  const double speed_mps = std::abs(v_mps);
  if (law_ == Law::kTable) return table_(speed_mps);  // (B8)
  const double f = 1e-3 * shoe_force_N / rail::kGravity_mps2;
  const double V = speed_mps * rail::kKmphPerMps;
  return 0.6 * (16.0 * f + 100.0) / (80.0 * f + 100.0) * (V + 100.0) / (5.0 * V + 100.0);  // (B7)
}

}  // namespace ltd
