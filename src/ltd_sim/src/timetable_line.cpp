#include "ltd_sim/timetable_line.hpp"

#include <algorithm>
#include <cmath>

namespace ltd {

namespace {

constexpr double kCell_m = 10.0;         // chosen, see the class
constexpr double kSample_m = 1.0;        // chosen: no limit is shorter
constexpr double kTableStep_mps = 0.25;  // chosen: traction over speed is smooth on it
constexpr double kCrawl_mps = 0.5;       // chosen: a train that cannot climb still has a finite running time
constexpr double kReserve = 0.85;        // chosen: of what full service gives; the rest corrects what he misjudged

}  // namespace

TimetableLine::TimetableLine(const rail::Track& track, const TrainAbility& ability, double deceleration_mps2,
                             double margin_mps)
    : start_m_(track.start_m()),
      deceleration_mps2_(deceleration_mps2),
      release_per_s_(ability.brake_response.release_per_s) {
  const double length_m = track.end_m() - track.start_m();
  cells_.resize(static_cast<std::size_t>(std::ceil(length_m / kCell_m)));
  buildLimits(track, ability, margin_mps);
  buildLosses(track, ability);
  buildForces(ability);
  buildCurves();
}

/// Backwards from the line's end. The brakes let go as late as they bite: towards a limit the deceleration fades with
/// rho = a release's F_full/m, so that the train is free again where it has the speed.
void TimetableLine::buildCurves() {
  smallest_speed_mps_ = cells_.back().limit_mps;
  double ahead = cells_.back().limit_mps;  // nothing is known beyond the end
  double down_to = ahead;                  // the limit that the curve reaches
  for (std::size_t i = cells_.size(); i-- > 0;) {
    Cell& cell = cells_[i];
    const double rho = release_per_s_ * between(full_mps2_, ahead);
    const double root = std::sqrt(std::max(0.0, ahead - down_to)) + std::sqrt(0.5 * rho) * kCell_m / ahead;
    const double a = deceleration(i, ahead);
    const double braked = std::min(std::sqrt(ahead * ahead + 2.0 * a * kCell_m), down_to + root * root);  // (V4)
    if (cell.limit_mps <= braked) down_to = cell.limit_mps;
    cell.permitted_mps = std::min(cell.limit_mps, braked);
    cell.deceleration_mps2 = std::max(0.0, 0.5 * (cell.permitted_mps * cell.permitted_mps - ahead * ahead) / kCell_m);
    ahead = cell.permitted_mps;
    smallest_speed_mps_ = std::min(smallest_speed_mps_, cell.limit_mps);
  }
}

/// a_s of (V4); not below a where there is no air brake to ask, which the reader refuses.
double TimetableLine::deceleration(std::size_t cell, double v_mps) const {
  const double most = kReserve * (between(full_mps2_, v_mps) + cells_[cell].loss_mps2);
  return most > 0.0 ? std::min(deceleration_mps2_, most) : deceleration_mps2_;
}

double TimetableLine::decelerationTo(double stop_m) const {
  double least = deceleration_mps2_, v = 0.0;
  for (std::size_t i = cellAt(stop_m) + 1; i-- > 0 && v < largest_speed_mps_;) {
    least = std::min(least, deceleration(i, v));
    v = std::sqrt(v * v + 2.0 * least * kCell_m);
  }
  return least;
}

void TimetableLine::buildLimits(const rail::Track& track, const TrainAbility& ability, double margin_mps) {
  const std::size_t n = cells_.size();
  std::vector<double> lowest(n);  // of the track alone
  std::size_t hint = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const double from_m = start_m_ + kCell_m * static_cast<double>(i);
    lowest[i] = track.at(from_m, hint).speed_limit_mps;
    for (double x = kSample_m; x < kCell_m; x += kSample_m)
      lowest[i] = std::min(lowest[i], track.at(from_m + x, hint).speed_limit_mps);
  }
  const auto ahead = static_cast<std::size_t>(std::ceil(ability.ahead_m / kCell_m));
  const auto behind = static_cast<std::size_t>(std::ceil(ability.behind_m / kCell_m));
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t from = i < behind ? 0 : i - behind, to = std::min(n - 1, i + ahead);
    const auto under = std::min_element(lowest.begin() + static_cast<std::ptrdiff_t>(from),
                                        lowest.begin() + static_cast<std::ptrdiff_t>(to) + 1);
    cells_[i].limit_mps = *under - margin_mps;
  }
}

void TimetableLine::buildLosses(const rail::Track& track, const TrainAbility& ability) {
  std::vector<double> turned{0.0};  // integral of |curvature| from the track's start
  std::size_t hint = 0;
  for (std::size_t i = 0; i < cells_.size(); ++i)
    turned.push_back(turned.back() +
                     kCell_m *
                         std::fabs(track.at(start_m_ + kCell_m * (static_cast<double>(i) + 0.5), hint).curvature_1pm));
  const double length_m = std::max(ability.ahead_m + ability.behind_m, kCell_m);
  std::size_t head_hint = 0, tail_hint = 0;
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    const double head_m = start_m_ + kCell_m * (static_cast<double>(i) + 0.5) + ability.ahead_m;
    const double tail_m = head_m - length_m;
    const double grade = (track.at(head_m, head_hint).height_m - track.at(tail_m, tail_hint).height_m) / length_m;
    const double curvature_1pm = (turned[cellAt(head_m)] - turned[cellAt(tail_m)]) / length_m;
    cells_[i].loss_mps2 = (ability.weight_N * grade + ability.curving_N_m * curvature_1pm) / ability.mass_kg;
  }
}

void TimetableLine::buildForces(const TrainAbility& ability) {
  for (const Cell& cell : cells_) largest_speed_mps_ = std::max(largest_speed_mps_, cell.limit_mps);
  for (double v = 0.0; v <= largest_speed_mps_ + 2.0 * kTableStep_mps; v += kTableStep_mps) {
    const double resistance_N = ability.resistance_N ? ability.resistance_N(v) : 0.0;
    pull_mps2_.push_back((ability.traction_N(ability.notches, v) - resistance_N) / ability.mass_kg);
    full_mps2_.push_back((ability.full_service_N ? ability.full_service_N(v) : 0.0) / ability.mass_kg);
  }
}

std::size_t TimetableLine::cellAt(double s_m) const {
  const double cell = std::floor((s_m - start_m_) / kCell_m);
  return static_cast<std::size_t>(std::clamp(cell, 0.0, static_cast<double>(cells_.size() - 1)));
}

double TimetableLine::permittedSpeed(double s_m) const {
  const std::size_t i = cellAt(s_m);
  const Cell& cell = cells_[i];
  const double next = i + 1 < cells_.size() ? cells_[i + 1].permitted_mps : cell.limit_mps;
  const double left_m = std::max(0.0, start_m_ + kCell_m * static_cast<double>(i + 1) - s_m);
  return std::min(cell.limit_mps, std::sqrt(next * next + 2.0 * cell.deceleration_mps2 * left_m));
}

/// Linear in a table over speed, constant beyond it.
double TimetableLine::between(const std::vector<double>& table, double v_mps) const {
  const double at = std::clamp(v_mps / kTableStep_mps, 0.0, static_cast<double>(table.size() - 1));
  const auto i = std::min(static_cast<std::size_t>(at), table.size() - 2);
  return table[i] + (table[i + 1] - table[i]) * (at - static_cast<double>(i));
}

double TimetableLine::runningTime(double from_m, double v_mps, double to_m, double stop_mps2, double cruise_mps) const {
  const bool stop = stop_mps2 > 0.0;
  double time_s = 0.0, s = from_m, v = v_mps;
  for (std::size_t i = cellAt(s); s < to_m; ++i) {
    i = std::min(i, cells_.size() - 1);
    const double cell_end = start_m_ + kCell_m * static_cast<double>(i + 1);
    const double next = cell_end > s ? std::min(cell_end, to_m) : to_m;
    const double d = next - s;
    double cap = std::min({cruise_mps, cells_[i].limit_mps, permittedSpeed(next)});
    if (stop) cap = std::min(cap, std::sqrt(2.0 * stop_mps2 * (to_m - next)));     // (V5)
    double v2 = v * v + 2.0 * (between(pull_mps2_, v) - cells_[i].loss_mps2) * d;  // (V6)
    if (v2 > cap * cap) v2 = std::max(cap * cap, v * v - 2.0 * deceleration(i, v) * d);
    const double v_next = std::sqrt(std::max(v2, 0.0));
    time_s += 2.0 * d / std::max(v + v_next, kCrawl_mps);
    v = std::max(v_next, stop && next >= to_m ? 0.0 : kCrawl_mps);
    s = next;
  }
  return time_s;
}

}  // namespace ltd
