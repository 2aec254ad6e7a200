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

TEST(BrakeResponseTest, TheTailIsFreeWhenTheBrakeItselfSaysSo) {
  for (const char* release : {"graduated", "direct"}) {
    BrakeText text;
    if (std::string(release) == "direct")
      text.valve =
          "{release: direct, first_reduction_bar: 0.4, release_rise_bar: 0.1, reservoir_charging_bar_per_s: 0.02}";
    const ltd::BrakeResponse response = responseOf(text);
    BrakeRig rig(text);
    rig.run(fixtures::pipeAt(3.5), 120.0);
    const double full_N = rig.force(107);
    const double free_s = rig.runUntil(fixtures::pipeAt(5.0), [&] { return rig.force(107) <= 0.05 * full_N; });
    EXPECT_NEAR(response.free_from_full_s, free_s, 0.5) << release;
  }
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
