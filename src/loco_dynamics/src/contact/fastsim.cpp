#include "loco_dynamics/contact/fastsim.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "fastsim_kernel.hpp"

namespace loco {

namespace {
constexpr double kPi = 3.14159265358979323846;
constexpr int kMostLanes = FastsimGrid::kMostCells + kFastsimLanes;
}  // namespace

FastsimGrid::FastsimGrid(int cells, int strips) : cells_(cells), strips_(strips) {
  assert(cells >= 1 && cells <= kMostCells && strips >= 1 && strips <= kMostCells);
  double sum_bound = 0.0;
  for (int i = 0; i < cells; ++i) {
    const double place = (cells - 2 * i - 1) / static_cast<double>(cells);
    place_.push_back(place);
    bound_.push_back(1.0 - place * place);
    sum_bound += bound_.back();
  }
  lanes_ = (strips + kFastsimLanes - 1) / kFastsimLanes * kFastsimLanes;
  double sum_weight = 0.0;
  for (int j = 0; j < lanes_; ++j) {  // y/b = sin t at equal steps of t: the integral over t is eta^4 dt
    const double y = j < strips ? std::sin(kPi * (2 * j + 1 - strips) / (2.0 * strips)) : 0.0;
    const double eta = std::sqrt(1.0 - y * y);
    y_.push_back(y);
    one_over_eta_.push_back(1.0 / eta);
    weight_.push_back(j < strips ? eta * eta * eta * eta : 0.0);
    sum_weight += weight_.back();
  }
  for (double& weight : weight_) weight /= sum_weight * sum_bound;
}

FastsimGrid::Force FastsimGrid::computeForce(const ContactPatch& patch, const Flexibilities& flexibility,
                                             const Creepage& creepage, double mu) const {
  // Step of q over a cell's length 2 a eta/cells where eta = 1. Stress on the wheel opposes the slip: hence the minus.
  const double largest_bound = 2.0 * mu * patch.normal_N / (kPi * patch.a_m * patch.b_m);  // mu p_n at the centre
  const double scale = -2.0 * patch.a_m / (cells_ * largest_bound);
  const double along = scale * creepage.xi_x / flexibility.l1;  // (C8)
  const double along_spin = -scale * creepage.phi_1pm * patch.b_m / flexibility.l3;
  const double across = scale * creepage.xi_y / flexibility.l2;
  const double across_spin = scale * creepage.phi_1pm * patch.a_m / flexibility.l3;

  double sum_x[kMostLanes];
  double sum_y[kMostLanes];
  alignas(64) double step_x[kFastsimMostLanes];
  alignas(64) double step_y[kFastsimMostLanes];
  for (int first = 0; first < lanes_; first += kFastsimMostLanes) {
    const int lanes = std::min(lanes_ - first, kFastsimMostLanes);
    const double* const y = &y_[static_cast<std::size_t>(first)];
    const double* const one_over_eta = &one_over_eta_[static_cast<std::size_t>(first)];
    for (int l = 0; l < lanes; ++l) {
      step_x[l] = (along + along_spin * y[l]) * one_over_eta[l];
      step_y[l] = across * one_over_eta[l];
    }
    marchStrips(
        {cells_, place_.data(), bound_.data(), lanes, step_x, step_y, across_spin, sum_x + first, sum_y + first});
  }

  Force force{0.0, 0.0};
  for (int j = 0; 2 * j < strips_; ++j) {  // mirrored strips together
    const int mirrored = strips_ - 1 - j;
    const double weight =
        j == mirrored ? 0.5 * weight_[static_cast<std::size_t>(j)] : weight_[static_cast<std::size_t>(j)];
    force.x_N += weight * (sum_x[j] + sum_x[mirrored]);
    force.y_N += weight * (sum_y[j] + sum_y[mirrored]);
  }
  const double full_slip = mu * patch.normal_N;
  return {full_slip * force.x_N, full_slip * force.y_N};
}

}  // namespace loco
