#pragma once

#include <gtest/gtest.h>

#include <string>

#include "ltd_sim/scenario.hpp"
#include "rail_core/constants.hpp"
#include "rail_core/world_track.hpp"
#include "train_viz/train_outline.hpp"

namespace fixtures {

/// The outline of a scenario of config/, as a watcher gets it: from the resolved text.
inline viz::TrainOutline outlineOf(const std::string& scenario) {
  rail::Problems problems;
  const rail::Document document =
      rail::Document::load(std::string(CONFIG_DIR) + "/scenarios/" + scenario + ".yaml", {}, problems);
  problems.throwIfAny();
  return viz::TrainOutline::read(document.text());
}

/// The paper's train and line: straight to 3.3 km, R300 to the left from 3.35 to 3.55 km.
class PaperLine : public ::testing::Test {
 protected:
  const viz::TrainOutline outline = outlineOf("paper_3d");
  const rail::WorldTrack world{outline.track};

  /// Vehicles in mid-slack with the leading locomotive's CoG at `head_m`.
  std::vector<double> placesFrom(double head_m) const {
    std::vector<double> s_m = {head_m};
    for (std::size_t i = 1; i < outline.vehicles.size(); ++i)
      s_m.push_back(s_m.back() - 0.5 * (outline.vehicles[i - 1].length_m + outline.vehicles[i].length_m));
    return s_m;
  }
  std::vector<double> noForces() const { return std::vector<double>(outline.vehicles.size() - 1, 0.0); }
};

}  // namespace fixtures
