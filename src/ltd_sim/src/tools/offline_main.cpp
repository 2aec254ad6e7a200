#include "ltd_sim/offline.hpp"

/// ltd_offline in a build without ROS: no bags.
int main(int argc, char** argv) { return ltd::runOffline({argv + 1, argv + argc}, {}); }
