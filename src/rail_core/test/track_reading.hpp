#pragma once

#include <string>
#include <vector>

#include "rail_core/track.hpp"

/// A track from the text of its map, and what was found wrong with it.
struct TrackReading {
  rail::Track track;
  std::vector<std::string> faults;
};

inline TrackReading readTrack(const std::string& text) {
  rail::Problems problems;
  const rail::Document document = rail::Document::parse(text, "track.yaml", problems);
  rail::Track track = rail::Track::read(rail::YamlReader(document, problems));
  return {track, problems.lines()};
}

/// The map of a table track; `rows` stand below the header.
inline std::string tableText(const std::string& rows, const std::string& grade = "constant",
                             const std::string& curvature = "constant") {
  std::string text = "name: table\nbetween_rows: {grade: " + grade + ", curvature: " + curvature +
                     "}\ntable: |\n  chainage_km,grade_permille,radius_m,cant_mm,speed_limit_kmph\n  ";
  for (const char c : rows) text += c == '\n' ? std::string("\n  ") : std::string(1, c);
  return text + "\n";
}
