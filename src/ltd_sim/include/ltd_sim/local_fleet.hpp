#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "loco_dynamics/local_port.hpp"
#include "ltd_sim/scenario.hpp"

namespace ltd {

/// All locomotives of a train in this process. They compute when the first answer is asked for, those of a step beside
/// each other on `threads` processors; they share nothing, so the bits do not depend on how many.
class LocalFleet {
 public:
  /// @param threads  1 or more; more than there are locomotives are not used
  LocalFleet(std::vector<std::unique_ptr<loco::Locomotive>> locomotives, int threads);
  ~LocalFleet();
  LocalFleet(const LocalFleet&) = delete;
  LocalFleet& operator=(const LocalFleet&) = delete;

  /// One for each locomotive, from the head.
  const std::vector<loco::LocoPort*>& ports() const { return ports_; }

 private:
  class Port : public loco::LocoPort {
   public:
    Port(LocalFleet& fleet, std::unique_ptr<loco::Locomotive> locomotive)
        : fleet_(fleet), locomotive_(std::move(locomotive)) {}
    void send(const loco::LocoForce& force, const std::vector<double>& state) override;
    const loco::LocoTraction* answer() override;
    void compute();

   private:
    LocalFleet& fleet_;
    loco::LocalPort locomotive_;
    const loco::LocoForce* force_ = nullptr;  ///< not computed yet
    const std::vector<double>* state_ = nullptr;
  };
  void compute();
  void computeShare();
  void work();

  std::vector<std::unique_ptr<Port>> owned_;
  std::vector<loco::LocoPort*> ports_;
  std::atomic<std::size_t> next_{0};  ///< locomotive that nobody has begun with
  std::mutex mutex_;                  ///< guards what follows
  std::condition_variable begun_, done_;
  std::uint64_t round_ = 0;
  std::size_t working_ = 0;  ///< helpers that have not ended the round
  bool ends_ = false;
  std::vector<std::thread> helpers_;
};

/// The locomotives of a scenario, from the head.
/// @throws rail::ConfigError with what is wrong with one
std::vector<std::unique_ptr<loco::Locomotive>> makeLocomotives(const Scenario& scenario);

/// How many threads pay: for locomotives whose step takes long against handing it over (3D), the machine's processors;
/// for others 1.
int threadsThatPay(const Scenario& scenario);

}  // namespace ltd
