#include "adhesion_control/controller_factory.hpp"

#include <gtest/gtest.h>

#include <string>

#include "controller_fixtures.hpp"

namespace {

using Grouping = adhesion::PiAdhesionController::Grouping;
using Lines = std::vector<std::string>;

constexpr rail::Nanoseconds kMicroStep = 1000000;

constexpr const char* kPi = R"(
law: pi
slip_limit: 0.05
proportional_gain_N_m: 2
integral_gain_N_m_per_s: 3
grouping: bogie
sampling_period_s: 0.004
torque_lag_s: 0.02
rim_power_limit: true
)";

adhesion::ControlParameters read(const rail::Document& document, rail::Problems& problems,
                                 rail::Nanoseconds micro_step = kMicroStep) {
  return adhesion::readController(rail::YamlReader(document, problems), micro_step);
}

Lines problemsOf(const std::string& text, rail::Nanoseconds micro_step = kMicroStep) {
  rail::Problems problems;
  read(rail::Document::parse(text, "c.yaml", problems), problems, micro_step);
  return problems.lines();
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

adhesion::ControlParameters readShipped(const std::string& name) {
  rail::Problems problems;
  const std::string file = std::string(TEST_DATA_DIR) + "/../../../config/control/" + name;
  const auto parameters = read(rail::Document::load(file, {}, problems), problems);
  EXPECT_EQ(problems.lines(), Lines());
  return parameters;
}

TEST(ControllerFactoryTest, AllFaultsAreToldAtOnce) {
  const std::string text = R"(
law: pi
slip_limit: 1
proportional_gain_N_m: 0
integral_gain_Nm_per_s: 3
grouping: wheel
sampling_period_s: 0.0015
torque_lag_s: -0.1
rim_power_limit: maybe
)";
  EXPECT_EQ(
      problemsOf(text),
      (Lines{
          "c.yaml: torque_lag_s = -0.1: must be a number >= 0 and <= 10",
          "c.yaml: rim_power_limit = maybe: must be true or false",
          "c.yaml: slip_limit = 1: must be a number > 0 and < 1",
          "c.yaml: proportional_gain_N_m = 0: must be a number > 0",
          "c.yaml: integral_gain_N_m_per_s: is missing: must be a number >= 0",
          "c.yaml: grouping = wheel: must be one of: axle, bogie",
          "c.yaml: sampling_period_s = 0.0015: must be 0 (every micro step) or a whole multiple of the micro step, "
          "0.001",
          "c.yaml: integral_gain_Nm_per_s = 3: unknown key, did you mean 'integral_gain_N_m_per_s'?",
      }));
}

TEST(ControllerFactoryTest, EveryKeyIsRequired) {
  const Lines lines = problemsOf("law: pi\n");
  EXPECT_EQ(lines.size(), 7u);
  for (const std::string& line : lines) EXPECT_NE(line.find("is missing"), std::string::npos) << line;
  EXPECT_EQ(problemsOf("law: none\n").size(), 2u);
}

TEST(ControllerFactoryTest, AnUnknownLawIsRefusedWithTheKnownOnes) {
  EXPECT_EQ(problemsOf(replaced(kPi, "law: pi", "law: pid")), (Lines{"c.yaml: law = pid: must be one of: pi, none"}));
}

TEST(ControllerFactoryTest, KeysOfAnotherLawAreRefused) {
  const Lines lines = problemsOf("{law: none, torque_lag_s: 0, rim_power_limit: false, slip_limit: 0.07}");
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_NE(lines[0].find("slip_limit = 0.07: unknown key"), std::string::npos) << lines[0];
}

TEST(ControllerFactoryTest, SamplingPeriodMustFitTheMicroStep) {
  EXPECT_EQ(problemsOf(kPi, 2000000), Lines());
  EXPECT_EQ(problemsOf(kPi, 3000000).size(), 1u);
  EXPECT_EQ(problemsOf(kPi, 8000000).size(), 1u);  // shorter than the micro step
  EXPECT_EQ(problemsOf(kPi, 0), Lines());          // not known here
  EXPECT_EQ(problemsOf(replaced(kPi, "0.004", "0"), 8000000), Lines());
  EXPECT_EQ(problemsOf(replaced(kPi, "0.004", "0.0033333333333333"), 0),
            (Lines{"c.yaml: sampling_period_s = 0.0033333333333333: must be a whole number of nanoseconds"}));
  EXPECT_EQ(problemsOf(replaced(kPi, "0.004", "1.0e-13")),
            (Lines{"c.yaml: sampling_period_s = 1.0e-13: must be a whole number of nanoseconds"}));
}

TEST(ControllerFactoryTest, EveryKeyGoesToItsField) {
  rail::Problems problems;
  const auto p = read(rail::Document::parse(kPi, "c.yaml", problems), problems);
  EXPECT_EQ(problems.lines(), Lines());
  EXPECT_EQ(p.law, "pi");
  EXPECT_EQ(p.torque_lag_s, 0.02);
  EXPECT_TRUE(p.rim_power_limit);
  EXPECT_EQ(p.pi.pi.slip_limit, 0.05);
  EXPECT_EQ(p.pi.pi.proportional_gain_N_m, 2.0);
  EXPECT_EQ(p.pi.pi.integral_gain_N_m_per_s, 3.0);
  EXPECT_EQ(p.pi.grouping, Grouping::kBogie);
  EXPECT_EQ(p.pi.sampling_period, 4000000);
}

TEST(ControllerFactoryTest, ShippedFilesHoldThePapersLimitAndTheChosenGains) {
  const auto axle = readShipped("pi_per_axle.yaml");
  const auto bogie = readShipped("pi_per_bogie.yaml");
  EXPECT_EQ(axle.pi.grouping, Grouping::kAxle);
  EXPECT_EQ(bogie.pi.grouping, Grouping::kBogie);
  for (const auto& p : {axle, bogie}) {
    EXPECT_EQ(p.law, "pi");
    EXPECT_EQ(p.pi.pi.slip_limit, 0.07);
    EXPECT_EQ(p.pi.pi.proportional_gain_N_m, 150e3);
    EXPECT_EQ(p.pi.pi.integral_gain_N_m_per_s, 1000e3);
    EXPECT_EQ(p.pi.sampling_period, 0);
    EXPECT_EQ(p.torque_lag_s, 0.0);
    EXPECT_FALSE(p.rim_power_limit);
  }
  EXPECT_EQ(readShipped("none.yaml").law, "none");
}

TEST(ControllerFactoryTest, MakesTheControllerThatTheFileNames) {
  // States: phase, I and R of every group; none; and a motor torque of every axle if there is a lag.
  EXPECT_EQ(adhesion::makeController(readShipped("pi_per_axle.yaml"), coCo())->stateSize(), 13u);
  EXPECT_EQ(adhesion::makeController(readShipped("pi_per_bogie.yaml"), coCo())->stateSize(), 5u);
  EXPECT_EQ(adhesion::makeController(readShipped("none.yaml"), coCo())->stateSize(), 0u);
  auto lagged = readShipped("none.yaml");
  lagged.torque_lag_s = 0.02;
  EXPECT_EQ(adhesion::makeController(lagged, coCo())->stateSize(), 6u);
}

TEST(ControllerFactoryTest, TheControllerHasTheValuesOfTheFile) {
  auto parameters = readShipped("pi_per_axle.yaml");
  parameters.pi.pi.slip_limit = 0.02;
  const auto controller = adhesion::makeController(parameters, coCo());
  Driven driven(*controller, coCo());
  driven.setSlip(0.03);
  driven.setReference(40e3);
  driven.step();
  EXPECT_NEAR(driven.commands[5].torque_N_m, 40e3 - 1500.0, 1e-6);
}

}  // namespace
