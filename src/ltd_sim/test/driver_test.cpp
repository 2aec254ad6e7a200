#include "ltd_sim/driver.hpp"

#include <gtest/gtest.h>

#include "train_fixtures.hpp"

namespace {

using ltd::Driver;

constexpr rail::Nanoseconds kStep = 2000000;  // 2 ms
constexpr rail::Nanoseconds kSecond = rail::kNanosecondsPerSecond;

const std::string kPaperNotches = "[0, 1], [10, 2], [20, 3], [30, 4], [40, 5], [50, 6], [60, 7], [70, 8]";

Driver read(const std::string& text, const std::vector<std::string>& groups, const std::vector<int>& largest) {
  return fixtures::readMap(
      text, [&](rail::YamlReader reader) { return Driver::read(reader, groups, largest, largest, kStep, {}); });
}

ltd::DriverView view(rail::Nanoseconds t, double location_m) {
  ltd::DriverView view;
  view.t = t;
  view.location_m = location_m;
  return view;
}

/// Notches of a group at the given times after a drive in macro steps along a place that does not change.
std::vector<int> notchesAt(const Driver& driver, std::size_t group, const std::vector<rail::Nanoseconds>& times) {
  Driver::State state;
  std::vector<int> notches;
  std::size_t next = 0;
  for (rail::Nanoseconds t = 0; next < times.size(); t += kStep) {
    driver.command(view(t, 3000.0), state);
    if (t == times[next]) {
      notches.push_back(driver.groupCommand(group, t, state).notch);
      ++next;
    }
  }
  return notches;
}

TEST(DriverTest, PapersDriverStartsInNotch1AddsOneEvery10SecondsAndStaysIn8From70SecondsOn) {
  const Driver driver = fixtures::makeDriver(kPaperNotches);
  std::vector<rail::Nanoseconds> times;
  for (int i = 0; i <= 20; ++i) times.push_back(i * 5 * kSecond);
  EXPECT_EQ(notchesAt(driver, 0, times),
            (std::vector<int>{1, 1, 2, 2, 3, 3, 4, 4, 5, 5, 6, 6, 7, 7, 8, 8, 8, 8, 8, 8, 8}));
}

TEST(DriverTest, NotchChangesInTheStepThatStartsAtItsTimeExactly) {
  const Driver driver = fixtures::makeDriver(kPaperNotches);
  EXPECT_EQ(notchesAt(driver, 0, {10 * kSecond - kStep, 10 * kSecond}), (std::vector<int>{1, 2}));
}

TEST(DriverTest, BeforeTheFirstEntryTheNotchIsZero) {
  const Driver driver = fixtures::makeDriver("[1, 4]");
  EXPECT_EQ(notchesAt(driver, 0, {0, kSecond - kStep, kSecond}), (std::vector<int>{0, 0, 4}));
}

TEST(DriverTest, OverPlaceTheNotchChangesOnceTheLeadingLocomotiveIsThere) {
  const Driver driver = fixtures::makeDriver("[3.0, 2], [3.15, 5], [3.3, 0]", "place");
  const auto notchAt = [&](double location_m) {
    Driver::State state;
    driver.command(view(0, location_m), state);
    return driver.groupCommand(0, 0, state).notch;
  };
  EXPECT_EQ(notchAt(2999.999), 0);
  EXPECT_EQ(notchAt(3000.0), 2);
  EXPECT_EQ(notchAt(3149.999), 2);
  EXPECT_EQ(notchAt(3150.0), 5);
  EXPECT_EQ(notchAt(3300.0), 0);
}

const std::string kGroups =
    "{over: time, notches: [[0, 1], [10, 4], [20, 8], [30, 0]], groups: {lead: {follows: lead}, "
    "late: {follows: lead, delay_s: 2.5}, lower: {follows: lead, notch_offset: -3}, "
    "higher: {follows: lead, notch_offset: 2}, idle: {notch: 0}, fixed: {notch: 5}}}";
const std::vector<std::string> kNames = {"lead", "late", "lower", "higher", "idle", "fixed"};

Driver driverOfSixGroups() { return read(kGroups, kNames, {8, 8, 8, 8, 8, 8}); }

TEST(DriverGroupTest, DelayedGroupFollowsExactlySoMuchLater) {
  const rail::Nanoseconds change = 12 * kSecond + kSecond / 2;
  EXPECT_EQ(notchesAt(driverOfSixGroups(), 1, {0, 5 * kSecond, change - kStep, change, 25 * kSecond, 35 * kSecond}),
            (std::vector<int>{0, 1, 1, 4, 8, 0}));
}

TEST(DriverGroupTest, GroupANumberOfNotchesLowerNeverGoesBelowZero) {
  EXPECT_EQ(notchesAt(driverOfSixGroups(), 2, {0, 10 * kSecond, 20 * kSecond, 30 * kSecond}),
            (std::vector<int>{0, 1, 5, 0}));
}

TEST(DriverGroupTest, GroupANumberOfNotchesHigherStopsAtItsLargestAndIdlesWithTheLead) {
  EXPECT_EQ(notchesAt(driverOfSixGroups(), 3, {0, 10 * kSecond, 20 * kSecond, 30 * kSecond}),
            (std::vector<int>{3, 6, 8, 0}));
}

TEST(DriverGroupTest, FixedGroupsDoNotCareAboutTheLead) {
  const Driver driver = driverOfSixGroups();
  EXPECT_EQ(notchesAt(driver, 4, {0, 20 * kSecond}), (std::vector<int>{0, 0}));
  EXPECT_EQ(notchesAt(driver, 5, {0, 20 * kSecond, 30 * kSecond}), (std::vector<int>{5, 5, 5}));
}

TEST(DriverGroupTest, DelayCountsFromTheChangeWhenDrivingOverPlace) {
  const Driver driver = read(
      "{over: place, notches: [[3.0, 1], [3.1, 6]], groups: {lead: {follows: lead}, late: {follows: lead, delay_s: "
      "1}}}",
      {"lead", "late"}, {8, 8});
  Driver::State state;
  driver.command(view(0, 3000.0), state);
  driver.command(view(7 * kSecond, 3100.0), state);
  EXPECT_EQ(driver.groupCommand(0, 7 * kSecond, state).notch, 6);
  EXPECT_EQ(driver.groupCommand(1, 8 * kSecond - kStep, state).notch, 1);
  EXPECT_EQ(driver.groupCommand(1, 8 * kSecond, state).notch, 6);
}

TEST(DriverGroupTest, BrakeNotchesAreDelayedAsWellButTheOffsetIsOfTractionAndAirIsTheLeads) {
  const Driver driver = read(
      "{over: time, notches: [[0, 3], [10, 0]], brake_notches: [[10, 6]], pipe_bar: [[10, 4.5]], sanding: [[10, 1]], "
      "groups: {lead: {follows: lead}, remote: {follows: lead, delay_s: 2, notch_offset: -1}, dead: {notch: 0}, "
      "helper: {brake_notch: 2}}}",
      {"lead", "remote", "dead", "helper"}, {8, 5, 8, 8});
  Driver::State state;
  driver.command(view(0, 0.0), state);
  driver.command(view(10 * kSecond, 0.0), state);
  const ltd::DriverCommand early = driver.groupCommand(1, 12 * kSecond - kStep, state);
  EXPECT_TRUE(early == (ltd::DriverCommand{2, 0, 4.5e5, 0.0, false, true}));
  const ltd::DriverCommand late = driver.groupCommand(1, 12 * kSecond, state);
  EXPECT_TRUE(late == (ltd::DriverCommand{0, 5, 4.5e5, 0.0, false, true}));  // 6 is more than this group has
  EXPECT_TRUE(driver.groupCommand(2, 12 * kSecond, state) == (ltd::DriverCommand{0, 0, 4.5e5, 0.0, false, true}));
  EXPECT_EQ(driver.groupCommand(3, 0, state).brake_notch, 2);
}

TEST(DriverGroupTest, StateRemembersChangesNotStepsAndNoFurtherBackThanTheLongestDelay) {
  for (const auto& [delay_s, most] : {std::pair(0, 1u), {3, 4u}}) {
    std::string notches = "[0, 1]";  // a change each second
    for (int t = 1; t < 100; ++t) notches += ", [" + std::to_string(t) + ", " + std::to_string(1 + t % 8) + "]";
    const Driver driver = read("{over: time, notches: [" + notches +
                                   "], groups: {late: {follows: lead, delay_s: " + std::to_string(delay_s) + "}}}",
                               {"late"}, {8});
    Driver::State state;
    std::size_t largest = 0;
    for (rail::Nanoseconds t = 0; t < 100 * kSecond; t += kSecond / 4) {
      driver.command(view(t, 0.0), state);
      const auto followed = static_cast<int>(std::max<rail::Nanoseconds>(0, t - delay_s * kSecond) / kSecond);
      if (t >= delay_s * kSecond) {
        ASSERT_EQ(driver.groupCommand(0, t, state).notch, 1 + followed % 8) << t;
      }
      largest = std::max(largest, state.changes.size());
    }
    EXPECT_EQ(largest, most);  // one in force, and those of the delay
  }
}

std::string csvDriver(const std::string& over, const std::vector<std::string>& lines) {
  std::string text = "over: " + over + "\ngroups: {lead: {follows: lead}}\nnotches_table: |\n";
  for (const std::string& line : lines) text += "  " + line + "\n";
  return text;
}

TEST(DriverCsvTest, ReadsNotchesOverTimeAndOverPlace) {
  const Driver over_time = read(csvDriver("time", {"time_s,notch", "0,1", "10,2"}), {"lead"}, {8});
  EXPECT_EQ(notchesAt(over_time, 0, {10 * kSecond - kStep, 10 * kSecond}), (std::vector<int>{1, 2}));
  const Driver over_place = read(csvDriver("place", {"notch,location_km", "3,3.0"}), {"lead"}, {8});
  Driver::State state;
  over_place.command(view(0, 3000.0), state);
  EXPECT_EQ(over_place.groupCommand(0, 0, state).notch, 3);
}

void expectFault(const std::string& text, const std::vector<std::string>& parts) {
  const auto faults = fixtures::faultsIn(
      text, [](rail::YamlReader reader) { return Driver::read(reader, {"lead"}, {8}, {8}, kStep, {}); });
  EXPECT_EQ(faults.size(), 1u) << fixtures::joined(faults);
  EXPECT_TRUE(fixtures::anyHas(faults, parts)) << fixtures::joined(faults);
}

TEST(DriverReadTest, RefusesABadCsvWithTheLineNumber) {
  expectFault(csvDriver("time", {"time_s,notch", "0,1", "0,2"}), {"line 3", "after the entry before"});
  expectFault(csvDriver("time", {"time_s,notch", "0,1", "10,9"}), {"line 3", "whole notch from 0 to 8"});
  expectFault(csvDriver("time", {"time_s,notch", "0,1.5"}), {"line 2", "whole notch from 0 to 8"});
  expectFault(csvDriver("time", {"time_s,notch", "0,1"}) + "notches: [[0, 1]]\n", {"notches", "beside notches_table"});
}

TEST(DriverReadTest, RefusesBadNotches) {
  const std::string rest = ", groups: {lead: {follows: lead}}}";
  expectFault("{over: time, notches: []" + rest, {"notches", "at least one entry"});
  expectFault("{over: time, notches: [[0, 1], [10]]" + rest, {"notches.1", "list of 2 numbers"});
  expectFault("{over: time, notches: [[10, 1], [0, 2]]" + rest, {"notches.1", "after the entry before"});
  expectFault("{over: time, notches: [[0, -1]]" + rest, {"notches.0", "-1", "whole notch"});
  expectFault("{over: time" + rest, {"notches", "is missing"});
  expectFault("{over: tide, notches: [[0, 1]]" + rest, {"over = tide", "time, place"});
}

TEST(DriverReadTest, RefusesBadGroups) {
  const std::string begin = "{over: time, notches: [[0, 1]], groups: ";
  expectFault(begin + "{}}", {"groups.lead", "is missing"});
  expectFault(begin + "{lead: {follows: lead}, remote: {follows: lead}}}", {"groups.remote", "unknown key"});
  expectFault(begin + "{lead: {follows: remote}}}", {"groups.lead.follows = remote", "lead"});
  expectFault(begin + "{lead: {notch: 9}}}", {"groups.lead.notch = 9", "<= 8"});
  expectFault(begin + "{lead: {follows: lead, delay_s: -1}}}", {"groups.lead.delay_s = -1", ">= 0"});
  expectFault(begin + "{lead: {follows: lead, notch_offset: -9}}}", {"groups.lead.notch_offset = -9"});
  expectFault(begin + "{lead: {notch: 1, brake_notch: 1}}}", {"groups.lead.brake_notch = 1", "never both"});
  expectFault(begin + "{lead: {notch: 0, follows: lead}}}", {"groups.lead.follows"});
}

}  // namespace
