#pragma once

#include <iosfwd>
#include <string>

#include "creep_force_arguments.hpp"

namespace loco {

/// Computes the cases of a CSV text (see kCreepForceHelp) and writes them with their forces.
/// Bad rows are named on `errors` and left out; a header that cannot be used leaves `output` empty.
/// @return exit status: 0, or 2 if anything was refused
int runCreepForce(const CreepForceArguments& arguments, const std::string& text, std::ostream& output,
                  std::ostream& errors);

/// The program: command line, standard input, standard output. @return exit status
int creepForceProgram(const std::vector<std::string>& arguments, std::istream& input, std::ostream& output,
                      std::ostream& errors);

}  // namespace loco
