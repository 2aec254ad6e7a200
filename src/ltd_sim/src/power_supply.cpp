#include "ltd_sim/power_supply.hpp"

#include <algorithm>
#include <cassert>
#include <limits>

#include "rail_core/message_number.hpp"

namespace ltd {

namespace {

const rail::Range kEfficiencies = rail::aboveUpTo(0.0, 1.0);
// Chosen, wider than any: a train of heated carriages takes less; kilowatts given for watts are not noticed here.
const rail::Range kAuxiliaries = rail::between(0.0, 1e6);

PowerSupply::Kind kindOf(const std::string& name) {
  if (name == "diesel") return PowerSupply::Kind::kDiesel;
  if (name == "diesel_storage") return PowerSupply::Kind::kDieselStorage;
  if (name == "storage") return PowerSupply::Kind::kStorage;
  return PowerSupply::Kind::kOverheadLine;
}

}  // namespace

double PowerSupply::State::residual() const {
  const double sources_J = fuel_J + line_drawn_J + recovered_rim_J + unserved_J + (stored_start_J - stored_J);
  const double sinks_J = motored_rim_J + auxiliaries_J + line_returned_J + to_resistors_J + motored_loss_J +
                         recovered_loss_J + generator_loss_J + engine_loss_J + storage_loss_J + line_loss_J;
  return sources_J - sinks_J;  // (F12)
}

PowerSupply PowerSupply::read(rail::YamlReader reader, double full_rim_power_W) {
  PowerSupply supply;
  const std::size_t problems_before = reader.problems().count();
  reader.text("name");
  const std::size_t problems_before_kind = reader.problems().count();
  supply.kind_ = kindOf(reader.choice("kind", {"diesel", "diesel_storage", "storage", "overhead_line"}));
  const bool known_kind = reader.problems().count() == problems_before_kind;
  supply.drivetrain_efficiency_ = reader.number("drivetrain_efficiency", kEfficiencies);
  supply.auxiliary_power_W_ = reader.number("auxiliary_power_W", kAuxiliaries);
  supply.auxiliary_share_ = reader.number("auxiliary_share_of_rim_power", rail::between(0.0, 1.0));
  if (known_kind) supply.readParts(reader);
  for (const char* const part : {"engine", "generator_efficiency", "storage", "line"}) reader.ignore(part);
  const bool readable = reader.problems().count() == problems_before;
  const double served_W = supply.computeRimPower(supply.engine_.ratedPower() * supply.generator_efficiency_);
  if (readable && supply.kind_ == Kind::kDiesel && served_W < full_rim_power_W)
    reader.refuse("engine.rated_power_W",
                  "serves " + rail::messageNumber(served_W, rail::Rounding::kDown) + " W at the rim, must serve " +
                      rail::messageNumber(full_rim_power_W, rail::Rounding::kUp) + " W, the most that `traction` asks");
  reader.finish();
  return supply;
}

void PowerSupply::readParts(rail::YamlReader& reader) {
  const std::string rule = "must not be given: a supply of this kind has none";
  if (hasEngine()) {
    engine_ = DieselEngine::read(reader.map("engine"));
    generator_efficiency_ = reader.number("generator_efficiency", kEfficiencies);
  } else {
    reader.refuseKey("engine", rule);
    reader.refuseKey("generator_efficiency", rule);
  }
  if (hasStorage()) {
    storage_ = EnergyStorage::read(reader.map("storage"));
  } else {
    reader.refuseKey("storage", rule);
  }
  if (hasLine()) {
    rail::YamlReader line = reader.map("line");
    line_efficiency_ = line.number("efficiency", kEfficiencies);
    line_regenerates_ = line.boolean("regenerates");
    line.finish();
  } else {
    reader.refuseKey("line", rule);
  }
}

PowerSupply::State PowerSupply::initialState() const {
  State state;
  if (hasStorage()) state.stored_J = state.stored_start_J = storage_.initialEnergy();
  return state;
}

void PowerSupply::step(const RimWork& work, double step_s, State& state) const {
  assert(step_s > 0.0);
  if (!exists()) return;
  const double to_motors_J = work.motored_J / drivetrain_efficiency_;      // (F1)
  const double from_motors_J = work.recovered_J * drivetrain_efficiency_;  // (F2)
  const double auxiliaries_J =
      auxiliary_power_W_ * step_s + auxiliary_share_ * (work.motored_J + work.recovered_J);  // (F3)
  state.motored_rim_J += work.motored_J;
  state.recovered_rim_J += work.recovered_J;
  state.motored_loss_J += to_motors_J - work.motored_J;
  state.recovered_loss_J += work.recovered_J - from_motors_J;
  const double asked_J = to_motors_J + auxiliaries_J - from_motors_J;  // (F4)
  const double lacking_J = serveLink(std::max(asked_J, 0.0), step_s, state);
  spillLink(std::max(-asked_J, 0.0), step_s, state);
  const double unfed_J = std::min(lacking_J, auxiliaries_J);
  state.auxiliaries_J += auxiliaries_J - unfed_J;
  state.auxiliaries_unfed_J += unfed_J;
  state.unserved_J += lacking_J - unfed_J;
  state.empty = hasStorage() && storage_.isEmpty(state.stored_J);
}

/// What the link is short of: from the storage first, the rest from engine or line.                      (F5)
/// @return what nobody gives [J], >= 0
double PowerSupply::serveLink(double asked_J, double step_s, State& state) const {
  double rest_J = asked_J;
  if (hasStorage()) {
    const double out_J = storage_.stepOut(asked_J, step_s, state.stored_J);
    state.storage_out_J += out_J;
    state.storage_loss_J += storage_.computeLossOut(out_J);
    rest_J -= out_J;
  }
  if (hasEngine()) {
    runEngine(rest_J, step_s, state);
    return 0.0;
  }
  if (hasLine()) {
    const double drawn_J = rest_J / line_efficiency_;
    state.line_drawn_J += drawn_J;
    state.line_loss_J += drawn_J - rest_J;
    return 0.0;
  }
  return rest_J;
}

/// What the link has too much of: into the storage, then back to the line, the rest into the resistors. (F6)
void PowerSupply::spillLink(double surplus_J, double step_s, State& state) const {
  double rest_J = surplus_J;
  if (hasStorage()) {
    const double in_J = storage_.stepIn(surplus_J, step_s, state.stored_J);
    state.storage_in_J += in_J;
    state.storage_loss_J += storage_.computeLossIn(in_J);
    rest_J -= in_J;
  }
  if (hasLine() && line_regenerates_) {
    const double returned_J = rest_J * line_efficiency_;
    state.line_returned_J += returned_J;
    state.line_loss_J += rest_J - returned_J;
  } else {
    state.to_resistors_J += rest_J;
  }
}

/// The engine for what the generator must give to the link; it idles if that is nothing.
void PowerSupply::runEngine(double link_J, double step_s, State& state) const {
  const double shaft_J = link_J / generator_efficiency_;
  const double fuel_J = engine_.computeFuel(shaft_J, step_s);
  state.generator_J += link_J;
  state.generator_loss_J += shaft_J - link_J;
  state.fuel_J += fuel_J;
  state.engine_loss_J += fuel_J - shaft_J;
  if (shaft_J <= 0.0) state.idle_fuel_J += fuel_J;
  state.overload_J += std::max(shaft_J - engine_.ratedPower() * step_s, 0.0);
}

/// Rim power that a power into the link serves beside the auxiliaries [W]: (F1), (F3) turned round, >= 0.
double PowerSupply::computeRimPower(double link_power_W) const {
  return std::max((link_power_W - auxiliary_power_W_) / (1.0 / drivetrain_efficiency_ + auxiliary_share_), 0.0);
}

double PowerSupply::availableRimPower(const State& state, double step_s) const {
  if (!hasStorage()) return std::numeric_limits<double>::infinity();
  const double storage_W = storage_.computeLargestOut(state.stored_J, step_s) / step_s;
  const double engine_W = hasEngine() ? engine_.ratedPower() * generator_efficiency_ : 0.0;
  return computeRimPower(storage_W + engine_W);  // (F13)
}

double PowerSupply::computeCharge(const State& state) const {
  return hasStorage() ? storage_.computeCharge(state.stored_J) : 0.0;
}

double PowerSupply::computeLitres(const State& state) const {
  return hasEngine() ? state.fuel_J / engine_.fuelEnergyPerLitre() : 0.0;  // (F14)
}

}  // namespace ltd
