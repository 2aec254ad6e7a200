#pragma once

#include "ltd_sim/diesel_engine.hpp"
#include "ltd_sim/energy_storage.hpp"
#include "ltd_sim/loco_energy.hpp"
#include "rail_core/yaml_reader.hpp"

namespace ltd {

/// Where one locomotive's energy comes from and goes to, from the wheel rims back to fuel, storage or line. Constant.
///
///   rail | rim -- drivetrain -- link -- generator -- shaft -- engine -- fuel
///                                |---- auxiliaries, storage, line, resistors
///
/// Motoring, the storage gives first (strategy `assist`, chosen), engine or line the rest; what then lacks, the
/// auxiliaries do without. Braking, what comes back feeds the auxiliaries, then the storage, then a line that takes it,
/// and the rest heats the resistors. The engine never charges the storage (chosen). Equations (F1) to (F16):
/// docs/energy.md.
///
/// YAML `supply`: name, kind (diesel, diesel_storage, storage, overhead_line), drivetrain_efficiency,
/// auxiliary_power_W, auxiliary_share_of_rim_power; with an engine `engine` and generator_efficiency, with a storage
/// `storage`, with a line `line: {efficiency, regenerates}`. A default-constructed one is no supply: it books nothing
/// and limits nothing.
class PowerSupply {
 public:
  enum class Kind { kNone, kDiesel, kDieselStorage, kStorage, kOverheadLine };

  /// What a locomotive's supply has done since the start of the run; energies >= 0 [J]. Copyable.
  struct State {
    double stored_J = 0.0, stored_start_J = 0.0;  ///< in the storage, now and at the start
    double motored_rim_J = 0.0;                   ///< work of the motors at the wheel rims
    double recovered_rim_J = 0.0;                 ///< work of the rims on the motors, in dynamic braking
    double motored_loss_J = 0.0;                  ///< between link and rim, motoring
    double recovered_loss_J = 0.0;                ///< between rim and link, braking
    double auxiliaries_J = 0.0;                   ///< compressor, fans, control: what they got from the link
    double auxiliaries_unfed_J = 0.0;             ///< and what they asked for beyond, in vain; for a report, no balance
    double generator_J = 0.0;                     ///< from the generator into the link
    double generator_loss_J = 0.0;                ///< between shaft and link
    double engine_loss_J = 0.0;                   ///< between fuel and shaft, idling included
    double fuel_J = 0.0;                          ///< lower heating value of all fuel burnt
    double idle_fuel_J = 0.0;                     ///< part of fuel_J: burnt while the shaft gave nothing
    double overload_J = 0.0;       ///< part of the shaft's work: beyond the rated power, for a report, no balance
    double storage_in_J = 0.0;     ///< from the link into the storage
    double storage_out_J = 0.0;    ///< from the storage into the link
    double storage_loss_J = 0.0;   ///< within the storage, both ways
    double line_drawn_J = 0.0;     ///< from the overhead line, before its loss
    double line_returned_J = 0.0;  ///< to the overhead line, after its loss
    double line_loss_J = 0.0;      ///< between line and link (transformer, converter), both ways
    double to_resistors_J = 0.0;   ///< recovered, and taken by nobody
    double unserved_J = 0.0;       ///< what the motors took from the link beyond what anybody gave it
    bool empty = false;            ///< the storage is at its lowest charge

    /// What the chain does not explain [J]: sources less sinks.                                         (F12)
    double residual() const;
  };

  /// @param full_rim_power_W  what the locomotive's drive may ask at the rim; an engine of kind diesel that cannot
  /// serve it, drivetrain, generator and auxiliaries is refused (0: unknown, refuse none for it)
  static PowerSupply read(rail::YamlReader reader, double full_rim_power_W);

  Kind kind() const { return kind_; }
  bool exists() const { return kind_ != Kind::kNone; }
  bool hasEngine() const { return kind_ == Kind::kDiesel || kind_ == Kind::kDieselStorage; }
  bool hasStorage() const { return kind_ == Kind::kStorage || kind_ == Kind::kDieselStorage; }
  bool hasLine() const { return kind_ == Kind::kOverheadLine; }

  State initialState() const;

  /// Books one macro step. @param step_s  macro step H, > 0
  void step(const RimWork& work, double step_s, State& state) const;

  /// Power at the rim [W] that the next step can be served with, >= 0. Infinite for none, diesel (its rated power was
  /// checked when it was read) and line.                                                               (F13)
  double availableRimPower(const State& state, double step_s) const;

  /// State of charge, share of the storage's capacity [-]; 0 without a storage.
  double computeCharge(const State& state) const;

  /// Litres of fuel burnt so far; 0 without an engine.                                                 (F14)
  double computeLitres(const State& state) const;

 private:
  void readParts(rail::YamlReader& reader);
  double computeRimPower(double link_power_W) const;
  double serveLink(double asked_J, double step_s, State& state) const;
  void spillLink(double surplus_J, double step_s, State& state) const;
  void runEngine(double link_J, double step_s, State& state) const;

  Kind kind_ = Kind::kNone;
  double drivetrain_efficiency_ = 1.0;
  double auxiliary_power_W_ = 0.0, auxiliary_share_ = 0.0;
  DieselEngine engine_;
  double generator_efficiency_ = 1.0;
  EnergyStorage storage_;
  double line_efficiency_ = 1.0;
  bool line_regenerates_ = false;
};

}  // namespace ltd
