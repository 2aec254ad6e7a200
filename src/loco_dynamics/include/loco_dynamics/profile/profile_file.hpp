#pragma once

#include <string>
#include <vector>

#include "loco_dynamics/profile/profile_points.hpp"
#include "rail_core/problems.hpp"

namespace loco {

/// What a profile is of: their checks differ.
enum class ProfileKind { kWheel, kRail };

/// Reads and checks a profile from CSV text with the columns y_mm,z_mm (in the frame of profile_points.hpp), from the
/// flange's back or the foot of the gauge face to the field side. All faults go to `problems` with file, line and rule.
/// @return the points; empty if anything was refused
ProfilePoints readProfileCsv(ProfileKind kind, const std::string& text, const std::string& file,
                             rail::Problems& problems);

/// A profile as the text of a file that readProfileCsv reads, with all digits and a comment on its frame.
std::string profileCsv(ProfileKind kind, const ProfilePoints& points);

}  // namespace loco
