#include "creep_curve.hpp"

#include <cmath>
#include <limits>

#include "loco_dynamics/contact/creepage.hpp"
#include "loco_dynamics/loco_factory.hpp"
#include "rail_core/document.hpp"
#include "rail_core/yaml_reader.hpp"

namespace viz {

namespace {

constexpr double kFinest = 1e-4;      // creep [-], chosen: the point next to 0, where the curve is still straight
constexpr double kPointsPerE = 12.0;  // chosen: the bend at the top looks round

struct LocomotiveEntry {
  rail::YamlReader vehicle;
  std::string model;
};

/// Counts `locomotive` down to the group that holds it.
std::optional<LocomotiveEntry> findLocomotive(rail::YamlReader& parent, const std::string& scenario_model,
                                              int& locomotive) {
  for (rail::YamlReader& group : parent.maps("groups")) {
    if (group.has("repeat")) {
      const int repeat = group.integer("repeat", 1);
      const int before = locomotive;
      if (auto found = findLocomotive(group, scenario_model, locomotive)) return found;
      const int in_one = before - locomotive;
      if (in_one > 0 && locomotive <= in_one * (repeat - 1)) {
        locomotive = (locomotive - 1) % in_one + 1;
        return findLocomotive(group, scenario_model, locomotive);
      }
      locomotive -= in_one * (repeat - 1);
    } else if (group.text("kind") == "locomotive") {
      const int count = group.integer("count", 1);
      if (locomotive <= count) return LocomotiveEntry{group.map("vehicle"), loco::readModelOr(group, scenario_model)};
      locomotive -= count;
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<CreepCurve> CreepCurve::read(const std::string& resolved, int locomotive, std::string& why_not) {
  rail::Problems problems;
  const rail::Document document = rail::Document::parse(resolved, "/train/configuration", problems);
  if (problems.empty()) {
    rail::YamlReader root(document, problems);
    rail::YamlReader train = root.map("train");
    int left = locomotive;
    auto found = findLocomotive(train, loco::readModel(root), left);
    if (problems.empty() && !found) {
      why_not = "the train has no locomotive " + std::to_string(locomotive);
      return std::nullopt;
    }
    if (problems.empty() && !loco::hasContacts(found->model)) {
      why_not = "1D locomotives have no wheels";
      return std::nullopt;
    }
    if (problems.empty() && loco::isSpatial(found->model)) {
      why_not = "3D: no one creep curve, the contact ellipses move";
      return std::nullopt;
    }
    if (problems.empty()) {
      const double radius_m = found->vehicle.map("bodies").number("wheel_radius_m", rail::positive());
      const auto parameters = loco::PlanarContact::read(found->vehicle.map("contact"), radius_m);
      const loco::RailConditions rail = loco::readRailConditions(root);
      if (problems.empty()) return CreepCurve(loco::PlanarContact(parameters, rail));
    }
  }
  why_not = problems.lines().front();
  return std::nullopt;
}

double CreepCurve::computeAdhesion(double creep, const Situation& now) const {
  const double slip_mps = creep * std::max(now.speed_mps, loco::kCreepageSpeedFloor_mps);  // see AxleAdhesion.msg
  const auto force =
      contact_.computeAxleForce(0.5 * now.axle_load_N, slip_mps, now.speed_mps, now.place_m, now.sanding);
  return now.axle_load_N > 0.0 ? force.force_N / now.axle_load_N : 0.0;
}

std::vector<Point> CreepCurve::computePoints(double least, double largest, const Situation& now) const {
  const auto steps = [](double end) {
    return end > kFinest ? static_cast<int>(std::ceil(kPointsPerE * std::log(end / kFinest))) : 0;
  };
  std::vector<Point> points;
  const auto add = [&](double creep) { points.push_back({creep, computeAdhesion(creep, now)}); };
  for (int i = steps(-least); i > 0; --i) add(-kFinest * std::pow(-least / kFinest, double(i) / steps(-least)));
  add(0.0);
  for (int i = 1; i <= steps(largest); ++i) add(kFinest * std::pow(largest / kFinest, double(i) / steps(largest)));
  return points;
}

}  // namespace viz
