#include "ltd_sim/timetable_driver.hpp"

namespace ltd {

TimetableDriver TimetableDriver::read(rail::YamlReader& reader, const rail::Track&, const TrainAbility&) {
  reader.refuse("kind", "is not known yet");
  return {};
}

void TimetableDriver::command(const DriverView&, State&, DriverCommand&) const {}

}  // namespace ltd
