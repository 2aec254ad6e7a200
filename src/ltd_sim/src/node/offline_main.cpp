#include "bag_writer.hpp"
#include "ltd_sim/offline.hpp"

/// ltd_offline: a scenario in one process, without a ROS master; see ltd_sim/offline.hpp.
int main(int argc, char** argv) {
  return ltd::runOffline({argv + 1, argv + argc}, [](const ltd::Scenario& scenario, const std::string& folder) {
    constexpr std::uint64_t kOfflineRun = 0;  // run id: no session to tell apart
    return std::make_unique<ltd::BagWriter>(scenario, folder, kOfflineRun);
  });
}
