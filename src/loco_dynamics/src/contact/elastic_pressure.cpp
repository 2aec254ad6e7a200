#include "loco_dynamics/contact/elastic_pressure.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace loco {

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr std::size_t kRows = 14;  ///< along x, of one half: the other is its mirror image
using Field = std::vector<double>;

/// Integral of 1/distance over the rectangle (0, x) (0, y), odd in both.
double corner(double x, double y) {
  const double r = std::hypot(x, y);
  return x * std::asinh(y / std::max(std::abs(x), 1e-30 + 1e-12 * r)) +
         y * std::asinh(x / std::max(std::abs(y), 1e-30 + 1e-12 * r));
}

/// Cells of the half x > 0, [row * columns + column], and what they do to each other.
struct Cells {
  std::size_t columns, count;
  double dx, dy;
  Field influence;  ///< deflection at the first of its rows (distance in rows) by unit pressure, mirrored cells apart
  double at(std::size_t rows_apart, std::size_t columns_apart) const {
    return influence[rows_apart * columns + columns_apart];
  }
};

Cells makeCells(const ContactSection& section, double half_length_m, const Elasticity& elasticity) {
  Cells cells{section.overlap_m.size(), kRows * section.overlap_m.size(), half_length_m / kRows, section.step_m, {}};
  const double compliance = 2.0 * (1.0 - elasticity.poisson * elasticity.poisson) / (kPi * elasticity.young_Pa);
  for (std::size_t i = 0; i < 2 * kRows; ++i) {
    for (std::size_t j = 0; j < cells.columns; ++j) {
      const double x = static_cast<double>(i) * cells.dx, y = static_cast<double>(j) * cells.dy;
      const double left = x - 0.5 * cells.dx, right = x + 0.5 * cells.dx, low = y - 0.5 * cells.dy,
                   high = y + 0.5 * cells.dy;
      cells.influence.push_back(compliance *
                                (corner(right, high) - corner(left, high) - corner(right, low) + corner(left, low)));
    }
  }
  return cells;
}

void deflect(const Cells& cells, const Field& pressure, Field& deflection) {
  for (std::size_t i = 0; i < cells.count; ++i) {
    const std::size_t row = i / cells.columns, column = i % cells.columns;
    double sum = 0.0;
    for (std::size_t j = 0; j < cells.count; ++j) {
      if (pressure[j] == 0.0) continue;
      const std::size_t other = j / cells.columns, at = j % cells.columns;
      const std::size_t across = column > at ? column - at : at - column;
      sum +=
          pressure[j] * (cells.at(row > other ? row - other : other - row, across) + cells.at(row + other + 1, across));
    }
    deflection[i] = sum;
  }
}

/// Takes the mean over the cells under pressure away.
void centre(const Field& pressure, Field& values) {
  double sum = 0.0, count = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (pressure[i] > 0.0) sum += values[i], count += 1.0;
  }
  for (double& value : values) value -= sum / count;
}

double product(const Field& pressure, const Field& a, const Field& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += pressure[i] > 0.0 ? a[i] * b[i] : 0.0;
  return sum;
}

/// One step of conjugate gradients; `turn` is 0 after cells came into contact. @return the same for the next step
double step(const Cells& cells, const Field& gap, double load, double& size, double turn, Field& pressure, Field& way) {
  Field left(cells.count), answer(cells.count);
  deflect(cells, pressure, left);
  for (std::size_t i = 0; i < cells.count; ++i) left[i] += gap[i];
  centre(pressure, left);
  const double before = size;
  size = product(pressure, left, left);
  for (std::size_t i = 0; i < cells.count; ++i)
    way[i] = pressure[i] > 0.0 ? left[i] + turn * size / before * way[i] : 0.0;
  deflect(cells, way, answer);
  centre(pressure, answer);
  const double length = product(pressure, left, way) / product(pressure, answer, way);
  double next_turn = 1.0, sum = 0.0;
  for (std::size_t i = 0; i < cells.count; ++i) {
    pressure[i] = std::max(0.0, pressure[i] - length * way[i]);
    if (pressure[i] == 0.0 && left[i] < 0.0) {
      pressure[i] = -length * left[i];
      next_turn = 0.0;
    }
    sum += pressure[i];
  }
  for (double& each : pressure) each *= load / sum;
  return next_turn;
}

}  // namespace

std::vector<double> computeElasticPressure(const ContactSection& section, double normal_N,
                                           const Elasticity& elasticity) {
  const double largest_m = *std::max_element(section.overlap_m.begin(), section.overlap_m.end());
  const double half_length_m = std::sqrt(2.0 * largest_m / section.along_1pm);  // of the undeformed bodies' overlap
  const Cells cells = makeCells(section, half_length_m, elasticity);
  Field gap(cells.count);
  for (std::size_t i = 0; i < cells.count; ++i) {
    const double x = (static_cast<double>(i / cells.columns) + 0.5) * cells.dx;
    gap[i] = 0.5 * section.along_1pm * x * x - section.overlap_m[i % cells.columns];
  }
  const double load = 0.5 * normal_N / (cells.dx * cells.dy);  // sum of one half's pressures
  Field pressure(cells.count, load / static_cast<double>(cells.count)), way(cells.count, 0.0);
  double size = 1.0, turn = 0.0;
  constexpr int kMostSteps = 60;
  constexpr double kFlat = 1e-5;  // chosen: of the overlap; pressures are then right to 1e-4
  const double enough = std::pow(kFlat * largest_m, 2) * static_cast<double>(cells.count);
  for (int i = 0; i < kMostSteps && (i == 0 || size > enough); ++i) {
    turn = step(cells, gap, load, size, turn, pressure, way);
  }
  return {pressure.begin(), pressure.begin() + static_cast<std::ptrdiff_t>(cells.columns)};
}

}  // namespace loco
