#!/usr/bin/env bash
# Installs what is missing, builds the workspace and its tests, and runs every test: with ROS (catkin: gtests, rostests,
# Python) and without (plain CMake). The last line is `N passed, M failed`; a test that runs in both builds counts once.
# Exits non-zero if a test failed, left no result, or none passed. Needs no master; rostests pick free ports.
# JOBS=n sets the number of compilers at once; tests run one at a time, for several of them need all processors.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/environment.sh"

if [[ $# -gt 0 ]]; then
  sed -n '2,5s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"
  [[ "$1" == "--help" || "$1" == "-h" ]] && exit 0
  echo "test: takes no arguments (one test alone: devel/lib/PACKAGE/TEST --gtest_filter=...)" >&2
  exit 2
fi

one_test_limit_s=1200
all_tests_limit='45 minutes'  # CI gives 90 minutes for everything; tests that come too late count as failed

not_built() {
  echo "test: $1 failed; no test was run" >&2
  echo "0 passed, 1 failed"  # whoever reads the last line only must not think that all is well
  exit 1
}

if [[ "$REPO" == *[[:space:]]* ]]; then
  not_built "running tests in a path with a space ($REPO; catkin does not quote its test commands: move the checkout)"
fi

# What would hide tests or make them depend on this shell.
unset GTEST_FILTER GTEST_OUTPUT GTEST_SHUFFLE GTEST_REPEAT GTEST_TOTAL_SHARDS GTEST_SHARD_INDEX
unset ROS_MASTER_URI ROS_HOSTNAME
export ROS_IP=127.0.0.1  # no test depends on how this machine's name resolves
export ROS_HOME="$REPO/build/ros_home" ROS_LOG_DIR="$REPO/build/ros_home/log" MPLCONFIGDIR="$REPO/build/ros_home/matplotlib"
export MPLBACKEND=Agg

# run_tests BUILD: leaves in BUILD test_list.json (what has to run), test_results/ (what ran), ctest.xml, ctest_status.
# ctest runs the very commands of `catkin_make run_tests`, but sees the exit code of a test (run_tests does not: a crash
# after the last test case stays unseen) and ends one that hangs.
run_tests() {
  local build=$1 status=0 flags=(-j1 --timeout "$one_test_limit_s")
  flags+=(--stop-time "$stop_time")
  if [[ "$(ctest --help)" == *--output-junit* ]]; then  # CMake 3.21; before, the XML of the tests themselves has to do
    flags+=(--output-junit "$build/ctest.xml")
  fi
  rm -rf "$build/test_results" "$build/ctest.xml" "$build/ctest_status" "$build/test_list.json"
  mkdir -p "$build/test_results" "$ROS_LOG_DIR" "$MPLCONFIGDIR"
  # gtests of the plain build write BUILD/test_results/EXECUTABLE.xml; catkin's commands name their file themselves
  (
    cd "$build"
    ctest --show-only=json-v1 > test_list.json
    GTEST_OUTPUT="xml:$build/test_results/" ctest "${flags[@]}" < /dev/null
  ) || status=$?
  echo "$status" > "$build/ctest_status"
}

"$REPO/scripts/build.sh" all tests || not_built "the build with catkin (see the first error above)"

cmake -S "$REPO/without_ros" -B "$REPO/build_plain" -DCMAKE_BUILD_TYPE=Release -DBUILD_TESTING=ON \
  || not_built "configuring the build without ROS (see above; after moving the checkout remove build_plain/)"
cmake --build "$REPO/build_plain" -j "$(parallel_jobs)" || not_built "the build without ROS (see the first error above)"

stop_time=$(date -d "+$all_tests_limit" +%H:%M:%S)
# catkin runs tests in an environment that it wrote down while configuring, and leaves out folders that were not there
# then: in a fresh checkout all that was just built. So let it write that down again.
cmake "$REPO/build" > "$REPO/build/configure_again.log" || not_built "configuring again"
run_tests "$REPO/build"
run_tests "$REPO/build_plain"
"$PYTHON" "$REPO/scripts/count_tests.py" --source "$REPO/src" "$REPO/build" "$REPO/build_plain"
