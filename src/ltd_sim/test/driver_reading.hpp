#pragma once

#include <gtest/gtest.h>

#include "train_fixtures.hpp"

/// Drivers from a text, with notches and brake notches up to 8 and H = 2 ms.
namespace drivers {

constexpr rail::Nanoseconds kStep = 2000000;  // 2 ms
constexpr rail::Nanoseconds kSecond = rail::kNanosecondsPerSecond;

inline ltd::Driver readFrom(rail::YamlReader reader) {
  return ltd::Driver::read(reader, {"lead"}, {8}, {8}, kStep, {});
}

inline ltd::Driver read(const std::string& text) {
  return fixtures::readMap(text + "groups: {lead: {follows: lead}}\n", readFrom);
}

/// A map entry `key: |` with these lines.
inline std::string table(const std::string& key, const std::vector<std::string>& lines) {
  std::string text = key + ": |\n";
  for (const std::string& line : lines) text += "  " + line + "\n";
  return text;
}

inline ltd::DriverView viewAt(rail::Nanoseconds t, double location_m) {
  ltd::DriverView view;
  view.t = t;
  view.location_m = location_m;
  return view;
}

/// What a driver without memory commands at a time and place.
inline ltd::DriverCommand commandAt(const ltd::Driver& driver, double time_s, double location_m = 0.0) {
  ltd::Driver::State state;
  driver.command(viewAt(rail::wholeNanoseconds(time_s).value(), location_m), state);
  return driver.lead(state);
}

/// Exactly one fault, with all the parts.
inline void expectFault(const std::string& text, const std::vector<std::string>& parts) {
  const auto faults = fixtures::faultsIn(text + "groups: {lead: {follows: lead}}\n", readFrom);
  EXPECT_EQ(faults.size(), 1u) << fixtures::joined(faults);
  EXPECT_TRUE(fixtures::anyHas(faults, parts)) << fixtures::joined(faults);
}

}  // namespace drivers
