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

/// Bilinear z(x, y) on a full grid, constant beyond its edges; x and y rise strictly; z[i][j] belongs to x[i], y[j].
class LookupTable2d {
 public:
  LookupTable2d() = default;
  /// @throws std::invalid_argument as above.
  LookupTable2d(std::vector<double> x, std::vector<double> y, std::vector<std::vector<double>> z);
  double operator()(double x, double y) const;
  double largest() const;

 private:
  std::vector<double> x_, y_;
  std::vector<std::vector<double>> z_;
};

/// "" if the numbers rise strictly, otherwise the rule with the offending index, counted from 0 as in keys
/// ("must rise: 3.2 after 3.5, entry 4").
std::string risingRule(const std::vector<double>& x);

}  // namespace rail
