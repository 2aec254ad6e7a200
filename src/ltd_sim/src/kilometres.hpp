#pragma once

#include <string>

#include "rail_core/constants.hpp"
#include "rail_core/message_number.hpp"

namespace ltd {

/// Where a train is, as reasons, notes and answers tell it: `3.142 km`
inline std::string kilometres(double s_m) { return rail::fixedNumber(s_m / rail::kMetresPerKilometre, 3) + " km"; }

}  // namespace ltd
