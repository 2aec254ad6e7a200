#include "ltd_sim/local_fleet.hpp"

#include <algorithm>
#include <utility>

#include "loco_dynamics/loco_factory.hpp"

namespace ltd {

void LocalFleet::Port::send(const loco::LocoForce& force, const std::vector<double>& state) {
  force_ = &force;
  state_ = &state;
}

const loco::LocoTraction* LocalFleet::Port::answer() {
  if (force_ != nullptr) fleet_.compute();
  return locomotive_.answer();
}

void LocalFleet::Port::compute() {
  if (force_ == nullptr) return;
  locomotive_.send(*force_, *state_);
  force_ = nullptr;
}

LocalFleet::LocalFleet(std::vector<std::unique_ptr<loco::Locomotive>> locomotives, int threads) {
  for (std::unique_ptr<loco::Locomotive>& locomotive : locomotives) {
    owned_.push_back(std::make_unique<Port>(*this, std::move(locomotive)));
    ports_.push_back(owned_.back().get());
  }
  for (int i = 1; i < threads && i < static_cast<int>(owned_.size()); ++i) helpers_.emplace_back([this] { work(); });
}

LocalFleet::~LocalFleet() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ends_ = true;
  }
  begun_.notify_all();
  for (std::thread& helper : helpers_) helper.join();
}

void LocalFleet::work() {
  std::unique_lock<std::mutex> lock(mutex_);
  for (std::uint64_t round = 0;;) {
    begun_.wait(lock, [&] { return ends_ || round_ != round; });
    if (ends_) return;
    round = round_;
    lock.unlock();
    computeShare();
    lock.lock();
    if (--working_ == 0) done_.notify_one();
  }
}

void LocalFleet::computeShare() {
  for (std::size_t i = next_++; i < owned_.size(); i = next_++) owned_[i]->compute();
}

void LocalFleet::compute() {
  next_ = 0;
  if (helpers_.empty()) return computeShare();
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ++round_;
    working_ = helpers_.size();
  }
  begun_.notify_all();
  computeShare();
  std::unique_lock<std::mutex> lock(mutex_);
  done_.wait(lock, [this] { return working_ == 0; });
}

std::vector<std::unique_ptr<loco::Locomotive>> makeLocomotives(const Scenario& scenario) {
  std::vector<std::unique_ptr<loco::Locomotive>> locomotives;
  rail::Problems problems;
  for (const LocoUnit& unit : scenario.train.locomotives) {
    locomotives.push_back(loco::makeLocomotive(scenario.document, unit.key, problems));
    problems.throwIfAny();
  }
  return locomotives;
}

int threadsThatPay(const Scenario& scenario) {
  const std::vector<LocoUnit>& units = scenario.train.locomotives;
  const auto spatial =
      std::count_if(units.begin(), units.end(), [](const LocoUnit& unit) { return loco::isSpatial(unit.model); });
  if (spatial < 2) return 1;
  return static_cast<int>(std::min<std::ptrdiff_t>(spatial, std::max(std::thread::hardware_concurrency(), 1u)));
}

}  // namespace ltd
