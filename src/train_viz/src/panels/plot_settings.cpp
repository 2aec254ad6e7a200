#include "plot_settings.hpp"

#include <sstream>

namespace viz {

std::string adhesionTopicOf(const PlotSettings& settings) {
  std::string topic = settings.adhesion_topic;
  const std::size_t at = topic.find("{}");
  if (at != std::string::npos) topic.replace(at, 2, std::to_string(settings.locomotive));
  return topic;
}

std::string namesOf(const std::vector<PlotKind>& plots) {
  std::string names;
  for (const PlotKind kind : plots) names += (names.empty() ? "" : ", ") + nameOf(kind);
  return names;
}

std::vector<PlotKind> plotsOf(const std::string& names, std::string& problem) {
  std::vector<PlotKind> plots;
  std::istringstream parts(names);
  for (std::string part; std::getline(parts, part, ',');) {
    const std::size_t first = part.find_first_not_of(' '), last = part.find_last_not_of(' ');
    part = first == std::string::npos ? "" : part.substr(first, last - first + 1);
    if (const auto kind = plotNamed(part)) {
      plots.push_back(*kind);
    } else {
      problem = "Plots: there is no plot '" + part + "', only " + namesOf(allPlots());
    }
  }
  return plots;
}

}  // namespace viz
