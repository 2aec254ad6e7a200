#include "train_viz/train_outline.hpp"

#include <sstream>

#include "ltd_sim/train_model.hpp"
#include "rail_core/document.hpp"

namespace viz {

namespace {

// Chosen, for what the scenario does not say: a common four-axle wagon has its pivots at 0.35 of its length over
// couplers, 1.8 m between a bogie's axles (Y25) and wheels of 0.92 m.
constexpr double kPivotShare = 0.35;
constexpr double kAxleSpacing_m = 1.8;
constexpr double kWheelRadius_m = 0.46;

/// The node at a dotted path. A YAML::Node that is assigned to writes into its tree, hence the recursion.
YAML::Node nodeAt(const YAML::Node& node, std::istringstream& path) {
  std::string key;
  if (!std::getline(path, key, '.')) return node;
  if (node.IsSequence()) return nodeAt(node[std::stoul(key)], path);
  return nodeAt(node[key], path);
}

BogieOutline makeBogie(double x_m, const std::vector<double>& axles_from_bogie_m) {
  BogieOutline bogie{x_m, {}};
  for (const double x : axles_from_bogie_m) bogie.axles_m.push_back(x_m + x);
  return bogie;
}

/// Bogies of a vehicle of which only length and number of axles are known: two with half the axles each.
void addUsualBogies(const rail::Vehicle& vehicle, VehicleOutline& outline) {
  const int axles = vehicle.axles / 2;
  std::vector<double> x_m;
  for (int i = 0; i < axles; ++i) x_m.push_back(kAxleSpacing_m * (0.5 * (axles - 1) - i));
  outline.wheel_radius_m = kWheelRadius_m;
  for (const double side : {1.0, -1.0}) outline.bogies.push_back(makeBogie(side * kPivotShare * vehicle.length_m, x_m));
}

/// The bogies that a locomotive's `bodies` name; the reader of the train has checked them.
void addBogies(const YAML::Node& bodies, VehicleOutline& outline) {
  const double pivot_m = bodies["bogie_frames"]["x_m"].as<double>();
  const auto x_m = bodies["wheelsets"]["x_m"].as<std::vector<double>>();
  outline.wheel_radius_m = bodies["wheel_radius_m"].as<double>();
  for (const double side : {1.0, -1.0}) outline.bogies.push_back(makeBogie(side * pivot_m, x_m));
}

}  // namespace

std::vector<double> VehicleOutline::axles_m() const {
  std::vector<double> all;
  for (const BogieOutline& bogie : bogies) all.insert(all.end(), bogie.axles_m.begin(), bogie.axles_m.end());
  return all;
}

TrainOutline TrainOutline::read(const std::string& resolved) {
  rail::Problems problems;
  const rail::Document document = rail::Document::parse(resolved, "/train/configuration", problems);
  problems.throwIfAny();
  rail::YamlReader root(document, problems);
  TrainOutline outline;
  outline.name = root.text("name");
  outline.track = rail::Track::read(root.map("track"));
  const ltd::TrainModel train = ltd::TrainModel::read(root.map("train"), root.text("locomotive_model"), false);
  problems.throwIfAny();
  outline.vehicles.resize(train.vehicles.size());
  for (const ltd::LocoUnit& unit : train.locomotives) {
    outline.locomotives.push_back(unit.vehicle);
    VehicleOutline& vehicle = outline.vehicles[unit.vehicle];
    vehicle.locomotive = static_cast<int>(outline.locomotives.size());
    std::istringstream path(unit.key + ".bodies");
    const YAML::Node bodies = nodeAt(document.root(), path);
    if (bodies.IsDefined()) addBogies(bodies, vehicle);
  }
  for (std::size_t i = 0; i < outline.vehicles.size(); ++i) {
    VehicleOutline& vehicle = outline.vehicles[i];
    vehicle.length_m = train.vehicles[i].length_m;
    if (vehicle.bogies.empty()) addUsualBogies(train.vehicles[i], vehicle);
  }
  return outline;
}

}  // namespace viz
