#include "ltd_sim/brake_response.hpp"

#include "brake_fixtures.hpp"

namespace {

using fixtures::BrakeRig;
using fixtures::BrakeText;

ltd::BrakeResponse responseOf(const BrakeText& text) {
  const ltd::TrainModel train = fixtures::brakedTrain();
  return ltd::computeBrakeResponse(train, fixtures::makeAirBrake(text, train));
}

TEST(BrakeResponseTest, WithoutABrakeNothingIsLate) {
  const ltd::BrakeResponse response = ltd::computeBrakeResponse(fixtures::brakedTrain(), ltd::AirBrake());
  EXPECT_EQ(response.delay_s, 0.0);
  EXPECT_EQ(response.free_from_full_s, 0.0);
}

TEST(BrakeResponseTest, ElectronicBrakesFollowAtTheCylindersRatesAfterTheSignal) {
  const ltd::BrakeResponse r = responseOf(fixtures::electronicBrake("1.0"));
  EXPECT_NEAR(r.fill_per_s, 0.95 / 24.0, 1e-3);          // (B5)
  EXPECT_NEAR(r.release_per_s, 3.4 / 3.8 / 52.0, 1e-4);  // likewise
  EXPECT_NEAR(r.delay_s, 1.0, 0.2);                      // two of its steps
  EXPECT_NEAR(r.release_delay_s, 1.0, 0.2);
  EXPECT_NEAR(r.free_from_full_s, 1.0 + 0.95 * 52.0 * 3.8 / 3.4, 0.3);  // down to a twentieth
}

TEST(BrakeResponseTest, PneumaticBrakesAreLateByTheWavesMeanWay) {
  const ltd::BrakeResponse r = responseOf({});
  // The mean vehicle is 820 m away at 200 m/s; the valve's first 0.4 bar, until it presses at all, take 1.6 s.
  EXPECT_NEAR(r.equivalentDelay(0.0, 1.0), 820.5 / 200.0 + 1.6 + 0.5 * 24.0 / 0.95, 0.6);
  EXPECT_GT(r.free_from_full_s, r.free_from_first_s + 20.0);
}

BrakeText directBrake(const std::string& position, const std::string& charging_bar_per_s) {
  BrakeText text;
  text.valve = "{release: direct, first_reduction_bar: 0.4, release_rise_bar: 0.1, reservoir_charging_bar_per_s: " +
               charging_bar_per_s + "}";
  if (position == "P")
    text.cylinder = "{position: P, full_bar: 3.8, fill_time_s: 4, emergency_fill_time_s: 4, release_time_s: 18}";
  return text;
}

/// Until the last vehicle drags no more, from this pressure of the pipe.
double freeFrom(const BrakeText& text, double pipe_bar) {
  BrakeRig rig(text);
  const double full_N = fixtures::tenthOfWeight(rig.train.vehicles[107]).largestRetardation(1.0, 10.0);
  rig.run(fixtures::pipeAt(pipe_bar), 120.0);
  return rig.runUntil(fixtures::pipeAt(5.0), [&] { return rig.force(107) <= 0.05 * full_N; });
}

TEST(BrakeResponseTest, TheTailIsFreeWhenTheBrakeItselfSaysSo) {
  for (const BrakeText& text : {BrakeText(), directBrake("G", "0.02"), directBrake("G", "0.01"),
                                directBrake("G", "0.005"), directBrake("P", "0.01"), directBrake("P", "0.005")}) {
    const ltd::BrakeResponse response = responseOf(text);
    EXPECT_NEAR(response.free_from_full_s, freeFrom(text, 3.5), 0.5) << text.text();  // of trials in 0.1 s, not 2 ms
    EXPECT_NEAR(response.free_from_first_s, freeFrom(text, 4.6), 0.5) << text.text();
    EXPECT_GT(response.free_from_first_s, 5.0) << text.text();
  }
}

TEST(BrakeResponseTest, HowFastReservoirsAreRechargedIsNothingToABrakeThatWasCharged) {
  for (const char* position : {"G", "P"}) {
    const ltd::BrakeResponse fast = responseOf(directBrake(position, "0.5"));
    for (const char* charging : {"0.02", "0.01", "0.005", "0.0001"}) {
      const ltd::BrakeResponse r = responseOf(directBrake(position, charging));
      EXPECT_EQ(r.delay_s, fast.delay_s) << position << charging;
      EXPECT_EQ(r.fill_per_s, fast.fill_per_s) << position << charging;
      EXPECT_EQ(r.release_delay_s, fast.release_delay_s) << position << charging;
      EXPECT_EQ(r.release_per_s, fast.release_per_s) << position << charging;
      EXPECT_EQ(r.free_from_first_s, fast.free_from_first_s) << position << charging;
      EXPECT_EQ(r.free_from_full_s, fast.free_from_full_s) << position << charging;
    }
    BrakeText graduated;
    graduated.cylinder = directBrake(position, "0.5").cylinder;
    const ltd::BrakeResponse same =
        responseOf(graduated);  // (B4) asks for what (B3) asks for as long as pressure falls
    EXPECT_NEAR(fast.delay_s, same.delay_s, 1e-6) << position;
    EXPECT_NEAR(fast.fill_per_s, same.fill_per_s, 1e-6) << position;
  }
}

/// 0.28 bar are 28 000.000000000004 Pa: the reduction that is tried out must not be rounded to less.
TEST(BrakeResponseTest, AFirstReductionThatIsNoRoundNumberIsTriedOutAsWell) {
  BrakeText text;
  text.valve.replace(text.valve.find("0.4"), 3, "0.28");
  EXPECT_GT(responseOf(text).free_from_first_s, 5.0);
}

TEST(BrakeResponseTest, ABrakeThatStartsAppliedIsTheSameBrake) {
  BrakeText applied;
  applied.start = "full_service";
  const ltd::BrakeResponse a = responseOf(applied), b = responseOf({});
  EXPECT_EQ(a.delay_s, b.delay_s);
  EXPECT_EQ(a.fill_per_s, b.fill_per_s);
  EXPECT_EQ(a.free_from_full_s, b.free_from_full_s);
}

}  // namespace
