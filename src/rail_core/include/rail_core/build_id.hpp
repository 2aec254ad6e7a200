#pragma once

#include <string>

namespace rail {

/// Of what source this program was built: `git describe` of the working tree, or the commit that `git archive` wrote
/// into the file VERSION. Train and locomotives must have the same; it stands in every bag.
std::string buildId();

}  // namespace rail
