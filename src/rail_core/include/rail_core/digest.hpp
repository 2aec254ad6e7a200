#pragma once

#include <cstdint>
#include <cstring>
#include <vector>

namespace rail {

/// Running 64-bit digest of numbers, bit for bit: two runs with the same digest exchanged the same payloads.
/// Each word is mixed in as h = mix(h ^ word) with the finalizer of splitmix64 (Steele, Lea, Flood 2014).
class Digest {
 public:
  void add(std::uint64_t word) {
    std::uint64_t h = (value_ ^ word) + 0x9e3779b97f4a7c15ULL;
    h = (h ^ (h >> 30)) * 0xbf58476d1ce4e5b9ULL;
    h = (h ^ (h >> 27)) * 0x94d049bb133111ebULL;
    value_ = h ^ (h >> 31);
  }
  void add(double number) {
    std::uint64_t word = 0;
    std::memcpy(&word, &number, sizeof word);
    add(word);
  }
  void add(const std::vector<double>& numbers) {
    add(static_cast<std::uint64_t>(numbers.size()));
    for (const double number : numbers) add(number);
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0;
};

/// Digest of what this processor's libm returns at a few places: glibc chooses code by processor family and differs in
/// the last bits between families. Two machines with the same number may share a run whose bits shall hold.
std::uint64_t arithmeticFingerprint();

}  // namespace rail
