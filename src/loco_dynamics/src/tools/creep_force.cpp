#include <unistd.h>

#include <iostream>

#include "creep_force_table.hpp"

/// Creep forces of cases on standard input; --help tells more.
int main(int argc, char** argv) {
  if (argc == 1 && isatty(STDIN_FILENO) != 0)  // a terminal: somebody may not know that it waits for him
    std::cerr << "creep_force: reads cases from standard input, creep_force < CASES.csv; --help tells more\n";
  return loco::creepForceProgram({argv + 1, argv + argc}, std::cin, std::cout, std::cerr);
}
