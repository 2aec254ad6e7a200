#pragma once

#include <string>
#include <vector>

namespace rail {

/// Piecewise linear y(x), constant beyond both ends. x rises strictly. Of a NaN it makes a NaN.
class LookupTable {
 public:
  LookupTable() = default;
  /// @throws std::invalid_argument if the sizes differ, it is empty, or x does not rise strictly (a programmer's error:
  /// readers check the user's tables first and name the row).
  LookupTable(std::vector<double> x, std::vector<double> y);
  double operator()(double x) const;
  const std::vector<double>& x() const { return x_; }
  const std::vector<double>& y() const { return y_; }

 private:
  std::vector<double> x_, y_;
};

/// "" if the numbers rise strictly, otherwise the rule with the offending index, counted from 0 as in keys
/// ("must rise: 3.2 after 3.5, entry 4").
std::string risingRule(const std::vector<double>& x);

}  // namespace rail
