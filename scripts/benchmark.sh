#!/usr/bin/env bash
# Builds and measures, without arguments: LTD per vehicle and step, the air brake, creep forces, a locomotive's micro step, the lock beside a raw TCP round trip, the paper's run, memory, start.
# For figures that mean something leave the machine alone meanwhile; for a change measure before and after in turn.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/environment.sh"

if [[ $# -gt 0 ]]; then
  sed -n '2,3s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"
  [[ "$1" == "--help" || "$1" == "-h" ]] && exit 0
  echo "benchmark: takes no arguments, got \"$1\"" >&2
  exit 2
fi

"$REPO/scripts/build.sh" > /dev/null
source_setup "$REPO/devel/setup.bash"
for subject in train_dynamics air_brake; do
  "$REPO/devel/lib/ltd_sim/${subject}_benchmark" --benchmark_repetitions=5 --benchmark_report_aggregates_only=true
done
for subject in contact loco; do
  "$REPO/devel/lib/loco_dynamics/${subject}_benchmark" --benchmark_repetitions=5 --benchmark_report_aggregates_only=true
done
"$PYTHON" "$REPO/src/ltd_sim/benchmark/graph_benchmark.py"
