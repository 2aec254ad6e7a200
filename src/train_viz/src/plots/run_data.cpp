#include "run_data.hpp"

#include <algorithm>

namespace viz {

namespace {

constexpr std::size_t kPlaces = 2048;   // chosen: as many as two subscribers' queues may be apart
constexpr std::size_t kWaiting = 2048;  // chosen: likewise
constexpr std::size_t kAxleBuckets = 1000;

/// Energies that a message does not have are not drawn.
void addIfThere(DecimatedSeries& series, double place_m, const std::vector<double>& values, std::size_t i) {
  if (i < values.size()) series.add({place_m, values[i]});
}

}  // namespace

void RunData::add(const TrainSample& sample) {
  if (train_ && sample.time_s < train_->time_s) {
    clear();
    run_known_ = false;
  }
  ++revision_;
  train_ = sample;
  places_.push_back({sample.time_s, sample.place_m});
  if (places_.size() > kPlaces) places_.pop_front();
  speed_.add({sample.place_m, sample.speed_mps});
  // a run's first state, before the first step, has none
  if (sample.speed_limit_mps > 0.0) speed_limit_.add({sample.place_m, sample.speed_limit_mps});
  if (locomotives_.size() < sample.traction_N.size()) locomotives_.resize(sample.traction_N.size());
  for (std::size_t i = 0; i < sample.traction_N.size(); ++i) {
    addIfThere(locomotives_[i].traction_N, sample.place_m, sample.traction_N, i);
    addIfThere(locomotives_[i].notch, sample.place_m, sample.notch, i);
    addIfThere(locomotives_[i].brake_notch, sample.place_m, sample.brake_notch, i);
  }
  couplers_.resize(sample.coupler_N.size());
  for (std::size_t i = 0; i < couplers_.size(); ++i) {
    couplers_[i].least_N = std::min(couplers_[i].least_N, sample.coupler_N[i]);
    couplers_[i].largest_N = std::max(couplers_[i].largest_N, sample.coupler_N[i]);
  }
  placeEnergies();
}

void RunData::add(const EnergySample& sample) {
  if (!waiting_.empty() && sample.time_s < waiting_.back().time_s) waiting_.clear();  // they were of another run
  waiting_.push_back(sample);
  if (waiting_.size() > kWaiting) waiting_.pop_front();
  placeEnergies();
}

std::optional<double> RunData::placeAt(double time_s) const {
  const auto later = std::lower_bound(places_.begin(), places_.end(), time_s,
                                      [](const Point& point, double time) { return point.x < time; });
  if (later == places_.end()) return std::nullopt;
  if (later->x == time_s) return later->y;
  if (later == places_.begin()) return std::nullopt;
  const Point& before = *(later - 1);
  return before.y + (later->y - before.y) * (time_s - before.x) / (later->x - before.x);
}

void RunData::placeEnergies() {
  while (!waiting_.empty() && !places_.empty() && waiting_.front().time_s <= places_.back().x) {
    if (const auto place_m = placeAt(waiting_.front().time_s)) book(waiting_.front(), *place_m);
    waiting_.pop_front();
  }
}

void RunData::book(const EnergySample& sample, double place_m) {
  ++revision_;
  if (locomotives_.size() < sample.rail_J.size()) locomotives_.resize(sample.rail_J.size());
  for (std::size_t i = 0; i < sample.rail_J.size(); ++i) {
    addIfThere(locomotives_[i].rail_J, place_m, sample.rail_J, i);
    addIfThere(locomotives_[i].rim_J, place_m, sample.rim_J, i);
    addIfThere(locomotives_[i].recovered_J, place_m, sample.recovered_J, i);
  }
}

void RunData::add(const AdhesionSample& sample) {
  if (adhesion_ && sample.time_s < adhesion_->time_s) clearAdhesion();
  ++revision_;
  adhesion_ = sample;
  if (axles_.size() < sample.axles.size()) axles_.resize(sample.axles.size(), DecimatedSeries(kAxleBuckets));
  for (std::size_t i = 0; i < sample.axles.size(); ++i)
    axles_[i].add({sample.axles[i].creep, sample.axles[i].adhesion});
}

void RunData::setRun(std::uint64_t run_id, const std::string& resolved) {
  if (run_known_ && run_id != run_id_) clear();
  run_known_ = true;
  if (run_id == run_id_ && resolved == resolved_) return;
  ++revision_;
  run_id_ = run_id;
  resolved_ = resolved;
  readCurve();
}

void RunData::readCurve() {
  creep_curve_.reset();
  why_no_curve_.clear();
  if (!resolved_.empty()) creep_curve_ = CreepCurve::read(resolved_, locomotive_, why_no_curve_);
}

void RunData::setLocomotive(int locomotive) {
  if (locomotive == locomotive_) return;
  locomotive_ = locomotive;
  clearAdhesion();
  readCurve();
}

void RunData::clearAdhesion() {
  ++revision_;
  axles_.clear();
  adhesion_.reset();
}

void RunData::clear() {
  clearAdhesion();
  locomotives_.clear();
  speed_.clear();
  speed_limit_.clear();
  train_.reset();
  couplers_.clear();
  places_.clear();
  waiting_.clear();
}

}  // namespace viz
