#include <iostream>

#include "wheel_rail_contact_table.hpp"

/// Contact patches of a wheelset on its track; --help tells more.
int main(int argc, char** argv) { return loco::wheelRailContactProgram({argv + 1, argv + argc}, std::cout, std::cerr); }
