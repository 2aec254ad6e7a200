#include "rail_core/digest.hpp"

#include <cmath>

namespace rail {

std::uint64_t arithmeticFingerprint() {
  Digest digest;
  // volatile: the compiler must not fold the calls with its own arithmetic.
  for (int i = 1; i <= 64; ++i) {
    volatile double x = 0.0371 * i;
    digest.add(std::tanh(x));
    digest.add(std::exp(-x));
    digest.add(std::sin(x));
    digest.add(std::cos(x));
    digest.add(std::atan2(x, 1.3));
    digest.add(std::acos(x / 3.0));
    digest.add(std::pow(x, 1.5));
    digest.add(std::log(x));
  }
  return digest.value();
}

}  // namespace rail
