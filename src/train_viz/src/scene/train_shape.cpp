#include "train_viz/train_shape.hpp"

#include <cmath>

#include "train_viz/colour_scale.hpp"

namespace viz {

namespace {

// Chosen: cross-sections of usual stock, and colours that none of the scales has. Heights above the rail tops.
constexpr double kWidth_m = 2.9;
constexpr double kFloor_m = 1.15;
constexpr double kLocoTop_m = 4.2;
constexpr double kWagonTop_m = 3.1;
constexpr double kRoofGap_m = 0.03;  // so that the box's own top is hidden from 500 m, too
constexpr double kBogieWidth_m = 2.3;
constexpr double kBogieBottom_m = 0.35;
constexpr double kBogieEnds_m = 1.2;  // both, beyond the outer axles
constexpr double kCouplerWidth_m = 0.4;
constexpr double kWheelWidth_m = 0.135;  // UIC 510-2
constexpr double kAxleRadius_m = 0.09;
constexpr double kDiagramHeight_m = -0.3;  // under the bed
constexpr double kDiagramOpacity = 0.5;
constexpr Colour kLoco{0.95, 0.6, 0.1, 1.0};
constexpr Colour kChosenLoco{1.0, 0.78, 0.25, 1.0};
constexpr Colour kWagon{0.36, 0.46, 0.42, 1.0};
constexpr Colour kBogie{0.16, 0.16, 0.18, 1.0};
constexpr Colour kGlassBogie{0.3, 0.3, 0.35, 0.3};
constexpr Colour kGlassWheel{0.6, 0.63, 0.68, 0.45};

/// @param X_WT  frame on the rail tops below it
Box boxOn(const Eigen::Isometry3d& X_WT, double length_m, double width_m, double bottom_m, double top_m,
          const Colour& colour) {
  Box box;
  box.X_WB = X_WT * Eigen::Translation3d(0.0, 0.0, 0.5 * (bottom_m + top_m));
  box.size_m = Eigen::Vector3d(length_m, width_m, top_m - bottom_m);
  box.colour = colour;
  return box;
}

/// The frame of a body on the rail tops: x along the chord from the rear bogie's place to the front one's, upright as
/// the line is at both, origin where the CoG is between them.
Eigen::Isometry3d chordFrame(const VehicleOutline& vehicle, const rail::WorldTrack& world, double s_m) {
  const double front_m = vehicle.bogies.front().x_m, rear_m = vehicle.bogies.back().x_m;
  const Eigen::Isometry3d X_WF = frameOf(world.at(s_m + front_m)), X_WR = frameOf(world.at(s_m + rear_m));
  const Eigen::Vector3d chord = X_WF.translation() - X_WR.translation();
  const Eigen::Vector3d x = chord.normalized();
  const Eigen::Vector3d y = (X_WF.linear().col(2) + X_WR.linear().col(2)).cross(x).normalized();
  Eigen::Isometry3d X_WT = Eigen::Isometry3d::Identity();
  X_WT.translation() = X_WR.translation() - rear_m / (front_m - rear_m) * chord;
  X_WT.linear() << x, y, x.cross(y);
  return X_WT;
}

Box bodyOf(const VehicleOutline& vehicle, const rail::WorldTrack& world, double s_m, bool chosen) {
  const Colour colour = !vehicle.locomotive ? kWagon : chosen ? kChosenLoco : kLoco;
  return boxOn(chordFrame(vehicle, world, s_m), vehicle.length_m - kBodyGap_m, kWidth_m, kFloor_m,
               vehicle.locomotive ? kLocoTop_m : kWagonTop_m, colour);
}

/// Of the body's full colour: rviz lights a box from where one looks, which leaves its top dark.
void addRoof(const Box& body, Triangles& roofs) {
  const Eigen::Vector3d h = 0.5 * body.size_m;
  const auto corner = [&](double x, double y) -> Eigen::Vector3d {
    return body.X_WB * Eigen::Vector3d(x * h.x(), y * h.y(), h.z() + kRoofGap_m);
  };
  roofs.add(corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0), body.colour);
}

Box bogieOf(const BogieOutline& bogie, const rail::WorldTrack& world, double s_m, const Colour& colour) {
  const double wheelbase_m = bogie.axles_m.empty() ? 0.0 : bogie.axles_m.front() - bogie.axles_m.back();
  return boxOn(frameOf(world.at(s_m + bogie.x_m)), wheelbase_m + kBogieEnds_m, kBogieWidth_m, kBogieBottom_m, kFloor_m,
               colour);
}

/// A wheelset: a cylinder's z is the axle's y.
void addWheelset(const Eigen::Isometry3d& X_WT, double wheel_radius_m, std::vector<Cylinder>& wheels) {
  const Eigen::Isometry3d X_WA =
      X_WT * Eigen::Translation3d(0.0, 0.0, wheel_radius_m) * Eigen::AngleAxisd(-0.5 * M_PI, Eigen::Vector3d::UnitX());
  wheels.push_back({X_WA, {2.0 * kAxleRadius_m, 2.0 * kAxleRadius_m, rail::kCantBaseline_m}, kGlassWheel});
  for (const double side : {0.5, -0.5})
    wheels.push_back({X_WA * Eigen::Translation3d(0.0, 0.0, side * rail::kCantBaseline_m),
                      {2.0 * wheel_radius_m, 2.0 * wheel_radius_m, kWheelWidth_m},
                      kGlassWheel});
}

void addChosenBogies(const VehicleOutline& vehicle, const rail::WorldTrack& world, double s_m, TrainShape& shape) {
  for (const BogieOutline& bogie : vehicle.bogies) {
    shape.chosen_bogies.push_back(bogieOf(bogie, world, s_m, kGlassBogie));
    shape.chosen_bogies.back().carrier = shape.chosen;
    for (const double x_m : bogie.axles_m)
      addWheelset(frameOf(world.at(s_m + x_m)), vehicle.wheel_radius_m, shape.chosen_wheels);
  }
}

void addCarriers(const TrainOutline& outline, const rail::WorldTrack& world,
                 const std::vector<double>& vehicle_location_m, TrainShape& shape) {
  shape.carriers = {trainCarrier(world, vehicle_location_m[outline.locomotives.front()])};
  for (const std::size_t vehicle : outline.locomotives)
    shape.carriers.push_back(
        locomotiveCarrier(world, *outline.vehicles[vehicle].locomotive, vehicle_location_m[vehicle]));
  shape.roofs.resize(shape.carriers.size());
  for (std::size_t i = 0; i < shape.roofs.size(); ++i) shape.roofs[i].carrier = i;
}

void addVehicle(const VehicleOutline& vehicle, const rail::WorldTrack& world, double s_m, int chosen,
                TrainShape& shape) {
  const auto carrier = static_cast<std::size_t>(vehicle.locomotive.value_or(0));
  const bool is_chosen = vehicle.locomotive == chosen;
  shape.bodies.push_back(bodyOf(vehicle, world, s_m, is_chosen));
  shape.bodies.back().carrier = carrier;
  addRoof(shape.bodies.back(), shape.roofs[carrier]);
  if (is_chosen) {
    shape.chosen = carrier;
    addChosenBogies(vehicle, world, s_m, shape);
    return;
  }
  for (const BogieOutline& bogie : vehicle.bogies) {
    shape.bogies.push_back(bogieOf(bogie, world, s_m, kBogie));
    shape.bogies.back().carrier = carrier;
  }
}

/// A body's end at the couplers' height. @param side  +1 front, -1 rear
Eigen::Vector3d endOf(const Box& body, double side) {
  const double below_centre_m = 0.5 * body.size_m.z() + kFloor_m - kCouplerHeight_m;
  return body.X_WB * Eigen::Vector3d(0.5 * side * body.size_m.x(), 0.0, -below_centre_m);
}

Box couplerBetween(const Eigen::Vector3d& front, const Eigen::Vector3d& rear, double force_N) {
  Box box;
  box.X_WB.translation() = 0.5 * (front + rear);
  box.X_WB.linear() = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitX(), front - rear).toRotationMatrix();
  box.size_m = Eigen::Vector3d((front - rear).norm(), kCouplerWidth_m, kCouplerWidth_m);
  box.colour = couplerColour(force_N);
  return box;
}

/// The band between the line and the forces, from coupler to coupler.
void addDiagram(const rail::WorldTrack& world, const std::vector<double>& place_m, const std::vector<double>& force_N,
                Triangles& diagram) {
  diagram.opacity = kDiagramOpacity;
  for (std::size_t i = 0; i + 1 < place_m.size(); ++i) {
    const Eigen::Isometry3d X_WF = frameOf(world.at(place_m[i])), X_WR = frameOf(world.at(place_m[i + 1]));
    const auto at = [](const Eigen::Isometry3d& X_WT, double y_m) -> Eigen::Vector3d {
      return X_WT * Eigen::Vector3d(0.0, y_m, kDiagramHeight_m);
    };
    const Colour colour = couplerColour(0.5 * (force_N[i] + force_N[i + 1]));
    diagram.add(at(X_WR, 0.0), at(X_WF, 0.0), at(X_WF, kDiagram_m_per_N * force_N[i]),
                at(X_WR, kDiagram_m_per_N * force_N[i + 1]), colour);
  }
}

}  // namespace

TrainShape computeTrainShape(const TrainOutline& outline, const rail::WorldTrack& world, int chosen,
                             const std::vector<double>& vehicle_location_m,
                             const std::vector<double>& coupler_force_N) {
  TrainShape shape;
  addCarriers(outline, world, vehicle_location_m, shape);
  for (std::size_t i = 0; i < outline.vehicles.size(); ++i)
    addVehicle(outline.vehicles[i], world, vehicle_location_m[i], chosen, shape);
  std::vector<double> place_m;
  for (std::size_t i = 0; i < coupler_force_N.size(); ++i) {
    shape.couplers.push_back(
        couplerBetween(endOf(shape.bodies[i], -1.0), endOf(shape.bodies[i + 1], 1.0), coupler_force_N[i]));
    place_m.push_back(vehicle_location_m[i] - 0.5 * outline.vehicles[i].length_m);
  }
  addDiagram(world, place_m, coupler_force_N, shape.force_diagram);
  return shape;
}

}  // namespace viz
