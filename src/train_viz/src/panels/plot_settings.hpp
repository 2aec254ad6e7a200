#pragma once

#include <string>
#include <vector>

#include "../plots/plots.hpp"

namespace viz {

/// What a layout says of a plot panel.
struct PlotSettings {
  std::string state_topic = "/train/state";
  std::string energy_topic = "/train/energy";
  std::string adhesion_topic = "/loco_{}/adhesion";  ///< {} stands for the locomotive's number
  std::string configuration_topic = "/train/configuration";
  std::string locomotive_topic = "/train_markers/locomotive";     ///< which one all who look have chosen; empty: alone
  std::string choice_topic = "/train_markers/choose_locomotive";  ///< where to ask for another one; empty: alone
  std::string export_topic;  ///< a folder's name published here has all plots written into it; empty: not listened to
  int locomotive = 1;        ///< from 1 at the head
  bool grid = false;         ///< all plots at once, not one tab each
  std::vector<PlotKind> plots = allPlots();
};

/// The topic of a locomotive.
std::string adhesionTopicOf(const PlotSettings& settings);
/// Names of plots, separated by commas.
std::string namesOf(const std::vector<PlotKind>& plots);
/// @param names    as above; empty: none
/// @param problem  names what is no plot; those are left out
std::vector<PlotKind> plotsOf(const std::string& names, std::string& problem);

}  // namespace viz
