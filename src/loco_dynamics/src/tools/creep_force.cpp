#include <iostream>

#include "creep_force_table.hpp"

/// Creep forces of cases on standard input; --help tells more.
int main(int argc, char** argv) {
  return loco::creepForceProgram({argv + 1, argv + argc}, std::cin, std::cout, std::cerr);
}
