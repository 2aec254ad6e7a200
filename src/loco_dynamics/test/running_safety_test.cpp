#include "loco_dynamics/running_safety.hpp"

#include <gtest/gtest.h>

namespace {

using loco::RunningSafety;
using loco::WheelsetContact;

constexpr double kRadius_m = 0.5335, kStep_s = 5e-4;

/// One contact a wheel with these loads; 0 is a contact that carries nothing.
WheelsetContact::Contacts contactsOf(double left_N, double right_N, double rise_of_left_m = 0.0) {
  WheelsetContact::Contacts contacts;
  contacts.count = 2;
  contacts.of_wheel = {1, 1};
  for (std::size_t i = 0; i < 2; ++i) {
    contacts.list[i].side = static_cast<loco::Side>(i);
    contacts.list[i].normal_N = i == 0 ? left_N : right_N;
    contacts.list[i].region.rolling_radius_m = kRadius_m + (i == 0 ? rise_of_left_m : 0.0);
  }
  return contacts;
}

std::string checkFor(double seconds, const WheelsetContact::Contacts& contacts, double z_m = 0.0) {
  double in_air_s[2] = {0.0, 0.0};
  std::string failure;
  for (double t = 0.0; t < seconds && failure.empty(); t += kStep_s)
    failure = RunningSafety{}.check("wheelset 3", 3412.0, kRadius_m, z_m, kStep_s, contacts, in_air_s);
  return failure;
}

TEST(RunningSafetyTest, LoadedWheelsAreSafe) { EXPECT_EQ(checkFor(1.0, contactsOf(1e5, 1e5)), ""); }

TEST(RunningSafetyTest, AWheelMayBounceButNotFly) {
  EXPECT_EQ(checkFor(0.09, contactsOf(1e5, 0.0)), "");
  EXPECT_EQ(checkFor(0.2, contactsOf(1e5, 0.0)),
            "wheelset 3, right wheel, at 3.412000 km: wheel lift, no contact with its rail");
}

TEST(RunningSafetyTest, TimeInTheAirCountsFromTheLastContact) {
  double in_air_s[2] = {0.0, 0.0};
  const RunningSafety safety;
  for (int i = 0; i < 150; ++i)
    safety.check("wheelset 3", 0.0, kRadius_m, 0.0, kStep_s, contactsOf(0.0, 1e5), in_air_s);
  EXPECT_NEAR(in_air_s[0], 0.075, 1e-12);
  safety.check("wheelset 3", 0.0, kRadius_m, 0.0, kStep_s, contactsOf(1.0, 1e5), in_air_s);
  EXPECT_EQ(in_air_s[0], 0.0);
}

TEST(RunningSafetyTest, BothWheelsInTheAirAreALossOfContact) {
  EXPECT_EQ(checkFor(0.2, contactsOf(0.0, 0.0)),
            "wheelset 3, at 3.412000 km: loss of contact, both wheels have left their rails");
}

TEST(RunningSafetyTest, AWheelOnItsFlangesTipClimbs) {
  EXPECT_EQ(checkFor(kStep_s, contactsOf(1e5, 1e5, 0.015)), "");
  EXPECT_EQ(checkFor(kStep_s, contactsOf(1e5, 1e5, 0.017)),
            "wheelset 3, left wheel, at 3.412000 km: flange climb, it runs beyond the flange's largest angle");
}

TEST(RunningSafetyTest, AWheelsetBetweenTheRailsHasFallen) {
  EXPECT_EQ(checkFor(kStep_s, contactsOf(0.0, 0.0), -0.05),
            "wheelset 3, at 3.412000 km: loss of contact, it fell between the rails");
}

}  // namespace
