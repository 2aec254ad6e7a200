#include "adhesion_control/controller_factory.hpp"

#include <cassert>
#include <optional>

#include "adhesion_control/lagged_controller.hpp"
#include "adhesion_control/pass_through_controller.hpp"
#include "rail_core/message_number.hpp"

namespace adhesion {

namespace {

using Made = std::unique_ptr<const AdhesionController>;

constexpr double kLongestTime_s = 10.0;  // chosen: a lag or period beyond it is a slip of the unit

/// 0 means every micro step.
rail::Nanoseconds readSamplingPeriod(rail::YamlReader& reader, rail::Nanoseconds micro_step) {
  const double period_s = reader.number("sampling_period_s", rail::between(0.0, kLongestTime_s));
  const std::optional<rail::Nanoseconds> period = rail::wholeNanoseconds(period_s);
  if (!period || (*period == 0 && period_s != 0.0)) {  // 1e-13 s would round to 0 and get another meaning
    reader.refuse("sampling_period_s", "must be a whole number of nanoseconds");
  } else if (micro_step > 0 && *period % micro_step != 0) {
    reader.refuse("sampling_period_s", "must be 0 (every micro step) or a whole multiple of the micro step, " +
                                           rail::exactNumber(rail::toSeconds(micro_step)));
  }
  return period.value_or(0);
}

void readPi(rail::YamlReader& reader, rail::Nanoseconds micro_step, ControlParameters& parameters) {
  PiAdhesionController::Parameters& p = parameters.pi;
  p.pi.slip_limit = reader.number("slip_limit", rail::Range{0.0, 1.0, false, false});
  p.pi.proportional_gain_N_m = reader.number("proportional_gain_N_m", rail::positive());
  p.pi.integral_gain_N_m_per_s = reader.number("integral_gain_N_m_per_s", rail::notNegative());
  const bool bogie = reader.choice("grouping", {"axle", "bogie"}) == "bogie";
  p.grouping = bogie ? PiAdhesionController::Grouping::kBogie : PiAdhesionController::Grouping::kAxle;
  p.sampling_period = readSamplingPeriod(reader, micro_step);
}

Made makePi(const ControlParameters& parameters, const Setup& setup) {
  return std::make_unique<PiAdhesionController>(parameters.pi, setup);
}

void readNone(rail::YamlReader&, rail::Nanoseconds, ControlParameters&) {}

Made makeNone(const ControlParameters&, const Setup&) { return std::make_unique<PassThroughController>(); }

/// One row for each law; the only place to change for another one.
struct Law {
  const char* name;
  void (*read)(rail::YamlReader&, rail::Nanoseconds micro_step, ControlParameters&);
  Made (*make)(const ControlParameters&, const Setup&);
};
constexpr Law kLaws[] = {
    {"pi", readPi, makePi},
    {"none", readNone, makeNone},
};

/// Null if there is none of that name.
const Law* findLaw(const std::string& name) {
  for (const Law& law : kLaws) {
    if (name == law.name) return &law;
  }
  return nullptr;
}

}  // namespace

const std::vector<std::string>& knownLaws() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const Law& law : kLaws) all.push_back(law.name);
    return all;
  }();
  return names;
}

ControlParameters readController(rail::YamlReader reader, rail::Nanoseconds micro_step) {
  ControlParameters parameters;
  const std::size_t problems_before = reader.problems().lines().size();
  parameters.law = reader.choice("law", knownLaws());
  const bool law_is_known = reader.problems().lines().size() == problems_before;
  parameters.torque_lag_s = reader.number("torque_lag_s", rail::between(0.0, kLongestTime_s));
  parameters.rim_power_limit = reader.boolean("rim_power_limit");
  if (!law_is_known) return parameters;  // which keys belong to it, too, is not known then
  findLaw(parameters.law)->read(reader, micro_step, parameters);
  reader.finish();
  return parameters;
}

std::unique_ptr<const AdhesionController> makeController(const ControlParameters& parameters, const Setup& setup) {
  const Law* const law = findLaw(parameters.law);
  assert(law != nullptr);
  Made controller = law->make(parameters, setup);
  if (parameters.torque_lag_s == 0.0) return controller;
  return std::make_unique<LaggedController>(std::move(controller), parameters.torque_lag_s, setup);
}

}  // namespace adhesion
