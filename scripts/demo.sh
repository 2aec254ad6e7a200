#!/usr/bin/env bash
# Runs the paper's case as a node graph, once for each locomotive model, draws the figures and compares with the paper.
#   scripts/demo.sh [--model 1d|2d|3d|3d_two_point|all] [--out DIR]
#     --model   default all: every model that has a config/scenarios/paper_MODEL.yaml
#     --out     default results/paper: DIR/report.html, DIR/figures, DIR/summary.csv, DIR/log, DIR/MODEL (bag, outcome.yaml,
#               summary.csv)
# Replaces earlier runs in DIR/MODEL, the report, summary and figures, nothing else. Exits non-zero unless every run finished
# and all results are there.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/environment.sh"

started_s=$SECONDS
known_models=(1d 2d 3d 3d_two_point)  # the last: 3D with another pair of profiles

usage() { sed -n '2,8s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"; }
fail() {
  echo "demo: $1" >&2
  exit "${2:-1}"
}

scenario_of() { echo "$REPO/config/scenarios/paper_$1.yaml"; }

model=all
out="$REPO/results/paper"
while [[ $# -gt 0 ]]; do
  case "$1" in
    --model | --out)
      [[ $# -ge 2 && -n "$2" ]] || fail "$1 needs a value; see --help" 2
      if [[ "$1" == "--model" ]]; then model=$2; else out=$2; fi
      shift 2
      ;;
    --model=*) model=${1#*=}; shift ;;
    --out=*) out=${1#*=}; shift ;;
    --help | -h) usage; exit 0 ;;
    *) usage >&2; fail "unknown argument \"$1\"" 2 ;;
  esac
done

# Which models: before anything is built, for a mistyped name should not cost minutes.
present=() absent=()
for name in "${known_models[@]}"; do
  if [[ -f "$(scenario_of "$name")" ]]; then present+=("$name"); else absent+=("$name"); fi
done
[[ ${#present[@]} -gt 0 ]] || fail "no config/scenarios/paper_MODEL.yaml in $REPO: is the checkout complete?"
if [[ "$model" == "all" ]]; then
  models=("${present[@]}")
  [[ ${#absent[@]} -eq 0 ]] || echo "demo: running ${present[*]}; not there yet: ${absent[*]}"
elif [[ " ${present[*]} " == *" $model "* ]]; then
  models=("$model")
else
  fail "no model \"$model\" (no config/scenarios/paper_$model.yaml); there are: ${present[*]} all" 2
fi

mkdir -p "$out" || fail "cannot make $out: give another --out"
out="$(CDPATH='' cd -- "$out" && pwd)"

is_ours_or_empty() { [[ ! -e "$1" || -f "$1/outcome.yaml" || (-d "$1" && -z "$(ls -A "$1")") ]]; }
for name in "${models[@]}"; do
  is_ours_or_empty "$out/$name" || fail "$out/$name exists and holds no outcome.yaml, so it is no earlier run: move it away \
or give another --out" 2
done

"$REPO/scripts/build.sh"
[[ -f "$REPO/launch/paper.launch" ]] || fail "no launch/paper.launch in $REPO: is the checkout complete?"
source_setup "$REPO/devel/setup.bash"

# Nothing is written to $HOME, and nothing listens to or talks to another master on this machine.
export ROS_HOME="$out/log/ros_home" ROS_LOG_DIR="$out/log" MPLCONFIGDIR="$out/log/matplotlib" MPLBACKEND=Agg
unset ROS_HOSTNAME
export ROS_IP=127.0.0.1
mkdir -p "$ROS_HOME" "$ROS_LOG_DIR" "$MPLCONFIGDIR"

roslaunch_pid=''
running_model=''

# LTD writes outcome.yaml. If it did not come to that, say so in its place: a later run knows the directory by this file.
note_missing_outcome() {
  local file="$out/$1/outcome.yaml"
  [[ -f "$file" ]] || printf 'outcome: failed\nreason: %s\n' "$2" > "$file"
}

# roslaunch ends its nodes and its master itself when it gets SIGINT: a node has 15 s, then SIGTERM, 2 s, SIGKILL.
end_roslaunch() {
  [[ -n "$roslaunch_pid" ]] || return 0
  local pid=$roslaunch_pid tenths
  roslaunch_pid=''
  kill -INT "$pid" 2>/dev/null || return 0
  for ((tenths = 0; tenths < 400; ++tenths)); do
    kill -0 "$pid" 2>/dev/null || return 0
    sleep 0.1
  done
  echo "demo: roslaunch (process $pid) did not end in 40 s, killing it; nodes that it leaves end themselves" >&2
  kill -KILL "$pid" 2>/dev/null || true
}
on_exit() {
  local status=$?
  trap '' INT TERM HUP  # a second Ctrl-C must not leave nodes behind
  end_roslaunch
  [[ -z "$running_model" ]] || note_missing_outcome "$running_model" "demo.sh was interrupted"
  exit "$status"
}
trap on_exit EXIT
trap 'echo "demo: interrupted, ending the nodes" >&2; exit 130' INT
trap 'exit 143' TERM
trap 'exit 129' HUP

free_port() {
  "$PYTHON" -c 'import socket; s = socket.socket(); s.bind(("127.0.0.1", 0)); print(s.getsockname()[1])'
}

# outcome_value KEY FILE
outcome_value() {
  "$PYTHON" -c 'import sys, yaml; print(yaml.safe_load(open(sys.argv[2])).get(sys.argv[1], ""))' "$1" "$2"
}

run_model() {
  local name=$1 port outcome reason launch_status=0 since=$SECONDS
  rm -rf "${out:?}/$name"
  mkdir "$out/$name"
  port=$(free_port)
  export ROS_MASTER_URI="http://127.0.0.1:$port"
  echo "demo: running $name (master at $ROS_MASTER_URI)"
  running_model=$name
  # A process group of its own (set -m): Ctrl-C reaches this script alone, which then ends roslaunch; and its children do
  # not inherit the ignored SIGINT of ordinary background jobs.
  set -m
  roslaunch -p "$port" "$REPO/launch/paper.launch" "model:=$name" record:=true rviz:=false "out:=$out/$name" < /dev/null &
  roslaunch_pid=$!
  set +m
  wait "$roslaunch_pid" || launch_status=$?
  roslaunch_pid=''
  note_missing_outcome "$name" "roslaunch ended with $launch_status before LTD wrote an outcome"
  running_model=''

  # roslaunch exits 0 whatever its nodes return; only the outcome counts
  outcome=$(outcome_value outcome "$out/$name/outcome.yaml") || fail "$out/$name/outcome.yaml is not readable"
  reason=$(outcome_value reason "$out/$name/outcome.yaml")
  [[ "$outcome" == "finished" ]] || fail "$name: ${outcome:-no outcome}: ${reason:-no reason given} (logs: $ROS_LOG_DIR)"
  [[ -s "$out/$name/summary.csv" ]] || fail "$name finished but left no $out/$name/summary.csv"
  compgen -G "$out/$name/*.bag" > /dev/null || fail "$name finished but left no bag in $out/$name"
  echo "demo: $name $outcome${reason:+: $reason} ($((SECONDS - since)) s)"
}

for name in "${models[@]}"; do
  run_model "$name"
done

runs=() bags=()
for name in "${models[@]}"; do
  runs+=("$out/$name")
  bags+=("$out/$name"/*.bag)
done
rosrun train_viz paper_comparison "${runs[@]}" --out "$out" || fail "no comparison: see the message above"
rosrun train_viz report "${bags[@]}" --out "$out/figures" || fail "no figures: see the message above"
for file in report.html summary.csv; do
  [[ -s "$out/$file" ]] || fail "$out/$file was not written"
done

echo "demo: results in $out"
echo "  report.html  our values beside the paper's: open it in a browser"
echo "  figures/     $(find "$out/figures" -type f | wc -l) files; Figs. 3, 6, 7, 8, 9 of the paper begin with fig;"
echo "               figures/report.html shows every other figure on one page"
echo "  summary.csv  energy and speeds of: ${models[*]}"
for name in "${models[@]}"; do
  printf '  %-12s bag, outcome.yaml, summary.csv\n' "$name/"
done
echo "demo: done in $((SECONDS - started_s)) s"
