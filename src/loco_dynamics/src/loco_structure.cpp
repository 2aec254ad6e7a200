#include "loco_dynamics/loco_structure.hpp"

#include <cmath>

#include "rail_core/constants.hpp"

namespace loco {

namespace {

using Eigen::Vector3d;

/// +value and -value, or 0 once.
std::vector<double> mirrored(double value) {
  return value == 0.0 ? std::vector<double>{0.0} : std::vector<double>{value, -value};
}

Vector3d readStiffness(rail::YamlReader& reader) {
  return {reader.number("longitudinal_N_per_m", rail::notNegative()),
          reader.number("lateral_N_per_m", rail::notNegative()), reader.number("vertical_N_per_m", rail::positive())};
}

Vector3d readDamping(rail::YamlReader reader) {
  const Vector3d damping(reader.number("longitudinal_N_s_per_m", rail::notNegative()),
                         reader.number("lateral_N_s_per_m", rail::notNegative()),
                         reader.number("vertical_N_s_per_m", rail::notNegative()));
  reader.finish();
  return damping;
}

/// A law as a list of pieces, each but the last with the argument at which it ends and, where the slope changes along
/// it, the slope there.
OddLaw readLaw(rail::YamlReader& reader, const std::string& key, const std::string& up_to, const std::string& slope) {
  std::vector<rail::YamlReader> maps = reader.maps(key);
  if (maps.empty() && reader.has(key)) reader.refuse(key, "must have at least one piece");
  std::vector<LawPiece> pieces;
  double last = 0.0;
  for (std::size_t i = 0; i < maps.size(); ++i) {
    LawPiece piece;
    piece.slope = maps[i].number(slope, rail::notNegative());
    if (i + 1 < maps.size()) {
      last = piece.up_to = maps[i].number(up_to, rail::above(last));
      const std::string slope_at_end = "end_" + slope;
      if (maps[i].has(slope_at_end)) piece.slope_rise = maps[i].number(slope_at_end, rail::notNegative()) - piece.slope;
    }
    maps[i].finish();
    pieces.push_back(piece);
  }
  return OddLaw(pieces);
}

/// Reads the file's maps in its order and builds the elements from them.
class StructureReader {
 public:
  explicit StructureReader(rail::YamlReader reader) : reader_(std::move(reader)) {}

  LocoStructure read() {
    out_.wheel_radius_m = reader_.number("wheel_radius_m", rail::between(0.2, 1.5));
    rail::YamlReader coupler = reader_.map("coupler");
    out_.coupler_x_m = coupler.number("x_m", rail::positive());
    out_.coupler_z_m = coupler.number("z_m", rail::positive());
    coupler.finish();
    out_.bodies.resize(BodyLayout::kBodies);
    readBodies();
    readSecondary(reader_.map("secondary"));
    readPrimary(reader_.map("primary"));
    readMotors();
    reader_.finish();
    return out_;
  }

 private:
  static Body readBody(rail::YamlReader& reader, const std::string& pitch_key, double z_m) {
    Body body;
    body.mass_kg = reader.number("mass_kg", rail::positive());
    body.inertia_kg_m2 = {reader.number("roll_inertia_kg_m2", rail::positive()),
                          reader.number(pitch_key, rail::positive()),
                          reader.number("yaw_inertia_kg_m2", rail::positive())};
    body.p_T = {0.0, 0.0, z_m};
    return body;
  }

  void readBodies() {
    rail::YamlReader car = reader_.map("car_body");
    out_.bodies[BodyLayout::kCar] = readBody(car, "pitch_inertia_kg_m2", car.number("z_m", rail::positive()));
    out_.bodies[BodyLayout::kCar].name = "car body";
    car.finish();

    rail::YamlReader frame = reader_.map("bogie_frames");
    const Body bogie = readBody(frame, "pitch_inertia_kg_m2", frame.number("z_m", rail::positive()));
    const double bogie_x_m = frame.number("x_m", rail::positive());
    frame.finish();

    rail::YamlReader sets = reader_.map("wheelsets");
    const Body wheelset = readBody(sets, "spin_inertia_kg_m2", out_.wheel_radius_m);
    out_.spin_momentum_inertia_kg_m2 = sets.number("spin_momentum_inertia_kg_m2", rail::notNegative());
    const std::vector<double> axle_x_m = sets.numbers("x_m", rail::anyNumber());
    if (axle_x_m.size() != BodyLayout::kAxlesPerBogie) sets.refuse("x_m", "must be three places, from the front");
    for (std::size_t i = 1; i < axle_x_m.size(); ++i)
      if (axle_x_m[i] >= axle_x_m[i - 1]) sets.refuse("x_m", "must fall: the first axle is in front");
    sets.finish();
    if (axle_x_m.size() != BodyLayout::kAxlesPerBogie) return;

    for (std::size_t i = 0; i < BodyLayout::kBogies; ++i) {
      const double x_m = i == 0 ? bogie_x_m : -bogie_x_m;
      Body& body = out_.bodies[BodyLayout::bogie(i)] = bogie;
      body.name = "bogie frame " + std::to_string(i + 1);
      body.p_T.x() = x_m;
      for (std::size_t j = 0; j < BodyLayout::kAxlesPerBogie; ++j) {
        const std::size_t axle = i * BodyLayout::kAxlesPerBogie + j;
        Body& set = out_.bodies[BodyLayout::wheelset(axle)] = wheelset;
        set.name = "wheelset " + std::to_string(axle + 1);
        set.p_T.x() = x_m + axle_x_m[j];
      }
    }
  }

  /// Point (x, y, z) of the locomotive from a body's CoG.
  Vector3d from(std::size_t body, const Vector3d& p_T) const { return p_T - out_.bodies[body].p_T; }

  void addSecondary(const std::string& name, std::size_t i, double x_m, double y_m, double z_m,
                    const Vector3d& stiffness, const Vector3d& damping) {
    const std::size_t bogie = BodyLayout::bogie(i);
    const Vector3d p(out_.bodies[bogie].p_T.x() + x_m, y_m, z_m);
    out_.suspension.springs.push_back(
        {name, BodyLayout::kCar, bogie, from(BodyLayout::kCar, p), from(bogie, p), stiffness, damping, false});
  }

  void readSecondary(rail::YamlReader reader) {
    const double z_m = reader.number("z_m", rail::positive());
    std::vector<rail::YamlReader> springs = reader.maps("springs");
    if (springs.empty() && reader.has("springs"))
      reader.refuse("springs", "must have at least one: they carry the car");
    for (rail::YamlReader& spring : springs) {
      const double x_m = spring.number("x_m", rail::notNegative());
      const double y_m = spring.number("y_m", rail::notNegative());
      const Vector3d stiffness = readStiffness(spring);
      spring.finish();
      for (std::size_t i = 0; i < BodyLayout::kBogies; ++i)
        for (const double x : mirrored(x_m))
          for (const double y : mirrored(y_m))
            addSecondary("secondary spring", i, x, y, z_m, stiffness, Vector3d::Zero());
    }
    const Vector3d rubber = readDamping(reader.map("damping_per_bogie"));
    rail::YamlReader lateral = reader.map("lateral_dampers");
    const double lateral_x_m = lateral.number("x_m", rail::notNegative());
    const double lateral_damping = lateral.number("damping_N_s_per_m", rail::notNegative());
    lateral.finish();
    for (std::size_t i = 0; i < BodyLayout::kBogies; ++i) {
      addSecondary("secondary damping", i, 0.0, 0.0, z_m, Vector3d::Zero(), rubber);
      for (const double x : mirrored(lateral_x_m))
        addSecondary("lateral damper", i, x, 0.0, z_m, Vector3d::Zero(), {0.0, lateral_damping, 0.0});
    }
    readYawDampers(reader.map("yaw_dampers"), z_m);
    readPins(reader.map("centre_pin"));
    reader.finish();
  }

  void readYawDampers(rail::YamlReader reader, double z_m) {
    const double y_m = reader.number("y_m", rail::positive());
    const double stiffness = reader.number("series_stiffness_N_per_m", rail::positive());
    const OddLaw damper = readLaw(reader, "damping", "up_to_mps", "slope_N_s_per_m");
    reader.finish();
    for (std::size_t i = 0; i < BodyLayout::kBogies; ++i) {
      const std::size_t bogie = BodyLayout::bogie(i);
      for (const double y : mirrored(y_m)) {
        const Vector3d p(out_.bodies[bogie].p_T.x(), y, z_m);
        out_.suspension.yaw_dampers.push_back(
            {BodyLayout::kCar, bogie, from(BodyLayout::kCar, p), from(bogie, p), stiffness, damper});
      }
    }
  }

  void readPins(rail::YamlReader reader) {
    const double x_m = reader.number("x_m", rail::positive());
    const double z_m = reader.number("z_m", rail::positive());
    const OddLaw longitudinal = readLaw(reader, "longitudinal", "up_to_m", "slope_N_per_m");
    const OddLaw lateral = readLaw(reader, "lateral", "up_to_m", "slope_N_per_m");
    reader.finish();
    for (std::size_t i = 0; i < BodyLayout::kBogies; ++i) {
      const std::size_t bogie = BodyLayout::bogie(i);
      const Vector3d p(i == 0 ? x_m : -x_m, 0.0, z_m);
      out_.suspension.pins.push_back(
          {BodyLayout::kCar, bogie, from(BodyLayout::kCar, p), from(bogie, p), longitudinal, lateral});
    }
  }

  void readPrimary(rail::YamlReader reader) {
    const double y_m = reader.number("y_m", rail::positive());
    const double z_m = reader.number("z_m", rail::positive());
    rail::YamlReader springs = reader.map("stiffness");
    const Vector3d stiffness = readStiffness(springs);
    springs.finish();
    const Vector3d damping = readDamping(reader.map("damping"));
    const double outer = reader.number("outer_axle_vertical_damping_N_s_per_m", rail::notNegative());
    reader.finish();
    for (std::size_t axle = 0; axle < BodyLayout::kAxles; ++axle) {
      const std::size_t set = BodyLayout::wheelset(axle), bogie = BodyLayout::bogieOfAxle(axle);
      const bool middle = axle % BodyLayout::kAxlesPerBogie == 1;
      for (const double y : mirrored(y_m)) {
        const Vector3d p(out_.bodies[set].p_T.x(), y, z_m);
        out_.suspension.springs.push_back({"primary", set, bogie, from(set, p), from(bogie, p), stiffness,
                                           damping + Vector3d(0.0, 0.0, middle ? 0.0 : outer), true});
      }
    }
  }

  /// Noses of the front bogie's motors; the rear bogie is its mirror image.
  void readMotors() {
    if (reader_.choiceOr("motor_reaction", {"couple", "nose"}, "couple") == "couple") return;
    out_.motor_reaction = MotorReaction::kNose;
    const std::vector<double> x_m = reader_.numbers("motor_nose_x_m", rail::between(-3.0, 3.0));
    if (x_m.size() != BodyLayout::kAxlesPerBogie)
      reader_.refuse("motor_nose_x_m", "must be three places, from the front");
    for (std::size_t i = 0; i < x_m.size() && i < BodyLayout::kAxlesPerBogie; ++i) {
      constexpr double kShortest_m = 0.1;  // chosen: a nose on the axle would need an infinite force
      if (std::abs(x_m[i]) < kShortest_m) reader_.refuse("motor_nose_x_m", "must be at least 0.1 m from the axle");
      out_.motor_nose_x_m[i] = x_m[i];
      out_.motor_nose_x_m[BodyLayout::kAxles - 1 - i] = -x_m[i];
    }
  }

  rail::YamlReader reader_;
  LocoStructure out_;
};

}  // namespace

double LocoStructure::totalMass() const {
  double mass_kg = 0.0;
  for (const Body& body : bodies) mass_kg += body.mass_kg;
  return mass_kg;
}

double LocoStructure::computeStaticSag() const {
  double primary_N_per_m = 0.0, secondary_N_per_m = 0.0;
  for (const SpringDamper& spring : suspension.springs)
    (spring.body_A == BodyLayout::kCar ? secondary_N_per_m : primary_N_per_m) += spring.stiffness_N_per_m.z();
  const double car_N = bodies[BodyLayout::kCar].mass_kg * rail::kGravity_mps2;
  double sprung_N = car_N;
  for (std::size_t i = 0; i < BodyLayout::kBogies; ++i)
    sprung_N += bodies[BodyLayout::bogie(i)].mass_kg * rail::kGravity_mps2;
  return sprung_N / primary_N_per_m + car_N / secondary_N_per_m;
}

LocoStructure LocoStructure::read(rail::YamlReader reader) { return StructureReader(std::move(reader)).read(); }

}  // namespace loco
