#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "wheel_rail_contact_arguments.hpp"

namespace loco {

/// The program: command line, standard output (see kWheelRailContactHelp). @return exit status
int wheelRailContactProgram(const std::vector<std::string>& arguments, std::ostream& output, std::ostream& errors);

}  // namespace loco
