#include "rail_core/digest.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace {

std::uint64_t digestOf(const std::vector<double>& numbers) {
  rail::Digest digest;
  digest.add(numbers);
  return digest.value();
}

TEST(DigestTest, TheSameNumbersGiveTheSameDigest) { EXPECT_EQ(digestOf({1.0, 2.5}), digestOf({1.0, 2.5})); }

TEST(DigestTest, TheLastBitTheSignOfZeroTheOrderAndTheLengthCount) {
  EXPECT_NE(digestOf({1.0}), digestOf({std::nextafter(1.0, 2.0)}));
  EXPECT_NE(digestOf({0.0}), digestOf({-0.0}));
  EXPECT_NE(digestOf({1.0, 2.0}), digestOf({2.0, 1.0}));
  EXPECT_NE(digestOf({0.0}), digestOf({0.0, 0.0}));
  EXPECT_NE(digestOf({}), digestOf({0.0}));
}

TEST(DigestTest, AWordIsMixedWithTheFinalizerOfSplitmix64) {
  rail::Digest digest;
  digest.add(std::uint64_t{0});
  EXPECT_EQ(digest.value(), 0xe220a8397b1dcdafULL);  // first output of splitmix64 for seed 0, a published test vector
}

TEST(DigestTest, TheArithmeticFingerprintIsTheSameAtEveryCall) {
  EXPECT_EQ(rail::arithmeticFingerprint(), rail::arithmeticFingerprint());
  EXPECT_NE(rail::arithmeticFingerprint(), 0u);
}

}  // namespace
