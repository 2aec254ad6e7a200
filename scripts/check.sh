#!/usr/bin/env bash
# Everything that CI asks of the source besides passing tests: format, lint, layering, warnings, a second build tool.
# Prints `ok NAME` or `FAILED NAME` with the reason for each check, runs them all, exits 1 if any failed.
#   scripts/check.sh [NAME...]     only these checks; --list names them
# JOBS=n sets the number of compilers at once. Builds in build_check/ only.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/environment.sh"

all_checks=(format lint includes compiler_flags shell_syntax python_syntax script_tests warnings colcon)
check_dir="$REPO/build_check"

cpp_files() {
  find "$REPO/src" -type f \( -name '*.cpp' -o -name '*.cc' -o -name '*.hpp' -o -name '*.h' \) -print0 | sort -z
}

# script_files LANGUAGE SUFFIX: files with this suffix, or without one but with LANGUAGE in their first line
script_files() {
  local language=$1 suffix=$2 file first
  while IFS= read -r -d '' file; do
    case "${file##*/}" in
      *."$suffix") printf '%s\0' "$file" ;;
      *.*) ;;
      *)
        first=''
        IFS= read -r first < "$file" 2>/dev/null || true
        if [[ "$first" == '#!'*"$language"* ]]; then printf '%s\0' "$file"; fi
        ;;
    esac
  done < <(find "$REPO/src" "$REPO/scripts" "$REPO/.ci" -type f -not -path '*/__pycache__/*' -print0 | sort -z)
}

check_format() {
  local files=() output
  mapfile -d '' files < <(cpp_files)
  if ! output=$(clang-format --style=file --dry-run --Werror "${files[@]}" 2>&1); then
    # the places, or what it says if it could not read the style or a file
    grep -E '\[-Wclang-format-violations\]' <<< "$output" | cut -d: -f1,2 | uniq || echo "$output"
    echo "mend with: clang-format -i FILE   ($(clang-format --version))"
    return 1
  fi
}

check_lint() {
  local found
  # what it says on stderr is only that it knows no rosdep database and how many packages it looked at
  found=$(cd "$REPO/src" && catkin_lint --offline --strict -W2 . 2> "$check_dir/catkin_lint.stderr") || true
  if [[ -n "$found" ]]; then
    echo "$found"
    echo "catkin_lint --help-problem lists what the messages mean"
    return 1
  fi
  # silent because it looked at nothing?
  grep -Eq 'checked [1-9][0-9]* packages' "$check_dir/catkin_lint.stderr" || { cat "$check_dir/catkin_lint.stderr"; return 1; }
}

# The physics knows no ROS: only node code, its tests, and the packages that are about ROS may include its headers.
check_includes() {
  local files=() file found=0
  mapfile -d '' files < <(cpp_files)
  for file in "${files[@]}"; do
    case "${file#"$REPO"/}" in
      src/*/src/node/* | src/*/include/*/node/* | src/*/test/node/* | src/train_viz/* | src/train_msgs/*) continue ;;
    esac
    if grep -HnE '^[[:space:]]*#[[:space:]]*include[[:space:]]*[<"](ros/|rosbag/|[A-Za-z0-9_]+_msgs/|tf2)' "$file"; then
      found=1
    fi
  done
  if [[ $found -ne 0 ]]; then
    echo "move the code to src/node/ (or test/node/) of its package, or hand the values over without ROS types"
    return 1
  fi
}

# These cost the same bits on every machine. Comments may name them.
check_compiler_flags() {
  local found
  # shellcheck disable=SC2016  # the $0 is awk's
  found=$(
    find "$REPO" \( -path "$REPO/build*" -o -path "$REPO/devel*" -o -path "$REPO/install" -o -path "$REPO/results" \) -prune \
      -o -type f \( -name CMakeLists.txt -o -name '*.cmake' -o -name '*.cmake.in' \) -print0 | sort -z \
      | xargs -0 awk '{ sub(/#.*/, "") } /-ffast-math|-march=native|-Ofast/ { print FILENAME ":" FNR ": " $0 }'
  )
  if [[ -n "$found" ]]; then
    echo "$found"
    return 1
  fi
}

check_shell_syntax() {
  local files=() file status=0
  mapfile -d '' files < <(script_files sh sh)
  for file in "${files[@]}"; do
    bash -n "$file" 2>&1 || status=1
  done
  return $status
}

check_python_syntax() {
  local files=() file status=0
  mapfile -d '' files < <(script_files python py)
  for file in "${files[@]}"; do
    PYTHONPYCACHEPREFIX="$check_dir/pycache" "$PYTHON" -m py_compile "$file" 2>&1 || status=1
  done
  return $status
}

check_script_tests() {
  local status=0
  for test in "$REPO"/scripts/*_test.py; do
    PYTHONDONTWRITEBYTECODE=1 "$PYTHON" "$test" 2>&1 || status=1
  done
  return $status
}

# Libraries, programs and benchmarks of the build without ROS; the tests are left to the colcon check, which compiles every
# file of every package, tests and nodes too, with the same option. Nothing that is long to compile is compiled twice.
check_warnings() {
  cmake -S "$REPO/without_ros" -B "$check_dir/plain" -DCMAKE_BUILD_TYPE=Release -DBUILD_TESTING=OFF \
    -DTRAIN_WARNINGS_AS_ERRORS=ON 2>&1
  cmake --build "$check_dir/plain" -j "$(parallel_jobs)" 2>&1
}

# colcon builds each package alone and installs it: what catkin_make does not see is a missing dependency or install rule.
check_colcon() {
  local base="$check_dir/colcon"
  rm -rf "$base/install"  # what is no longer installed must not be found
  (
    cd "$REPO"
    COLCON_HOME="$base/home" MAKEFLAGS="-j$(parallel_jobs)" colcon --log-base "$base/log" build --base-paths src \
      --build-base "$base/build" --install-base "$base/install" --merge-install --executor sequential --continue-on-error \
      --event-handlers console_direct+ \
      --cmake-args -DCMAKE_BUILD_TYPE=Release -DPYTHON_EXECUTABLE="$PYTHON" -DTRAIN_WARNINGS_AS_ERRORS=ON 2>&1
  )
  source_setup "$base/install/setup.sh"  # Debian's colcon writes no setup.bash
  local file package where program status=0
  for file in "$REPO"/src/*/package.xml; do
    package=$("$PYTHON" -c 'import sys, xml.etree.ElementTree as e; print(e.parse(sys.argv[1]).findtext("name"))' "$file")
    where=$(rospack find "$package" 2>&1) || true
    if [[ "$where" != "$base/install/"* ]]; then
      echo "rospack does not find $package in $base/install but says: $where"
      status=1
    fi
    for program in "$base/build/$package/devel/lib/$package"/*; do
      case "${program##*/}" in
        '*' | *.py | *_test | *_benchmark) continue ;;  # no program at all, or one that is not for users
      esac
      if [[ -f "$program" && -x "$program" && ! -x "$base/install/lib/$package/${program##*/}" ]]; then
        echo "$package: program ${program##*/} is built but not installed: add it to install(TARGETS ...)"
        status=1
      fi
    done
  done
  check_installed_launch || status=1
  return $status
}

# In the environment of an install space, called from a folder that knows nothing of the checkout.
check_installed_launch() {
  local folder="$check_dir/launched" port layout
  rm -rf "$folder"
  mkdir -p "$folder"
  port=$("$PYTHON" -c 'import socket; s = socket.socket(); s.bind(("127.0.0.1", 0)); print(s.getsockname()[1])')
  layout=$(roslaunch --args /rviz ltd_sim rviz.launch) || return 1
  layout=$(sed 's/.* -d \([^ ]*\).*/\1/' <<< "$layout")
  [[ -f "$layout" ]] || { echo "rviz.launch finds no layout: $layout"; return 1; }
  (
    cd "$folder"
    export ROS_HOME="$folder/home" ROS_IP=127.0.0.1 ROS_MASTER_URI="http://127.0.0.1:$port"
    roslaunch -p "$port" ltd_sim paper.launch model:=1d set:='run.end_time_s=2' 2>&1
  )
  grep -qx 'outcome: finished' "$folder/results/paper_1d/outcome.yaml" || { echo "paper.launch of the install space did not finish"; return 1; }
}

wanted=()
for argument in "$@"; do
  case "$argument" in
    --help | -h) sed -n '2,5s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"; exit 0 ;;
    --list) printf '%s\n' "${all_checks[@]}"; exit 0 ;;
    *)
      if [[ " ${all_checks[*]} " != *" $argument "* ]]; then
        echo "check: no check \"$argument\"; there are: ${all_checks[*]}" >&2
        exit 2
      fi
      wanted+=("$argument")
      ;;
  esac
done
[[ ${#wanted[@]} -gt 0 ]] || wanted=("${all_checks[@]}")

install_dependencies
mkdir -p "$check_dir"
failures=()
for name in "${wanted[@]}"; do
  log="$check_dir/$name.log"
  # `if check` would switch `set -e` off inside the check
  set +e
  (
    set -euo pipefail
    "check_$name"
  ) > "$log" 2>&1 < /dev/null
  status=$?
  set -e
  if [[ $status -eq 0 ]]; then
    echo "ok $name"
  else
    failures+=("$name")
    echo "FAILED $name"
    # compilers are long-winded: their errors first, and the end of the log; all of it stays in the file
    { grep -nE '(error|warning):|CMake Error|\*\*\*' "$log" | head -n 30; echo '...'; tail -n 40 "$log"; } > "$log.short" || true
    if [[ $(wc -l < "$log") -le 80 ]]; then
      sed 's/^/    /' "$log"
    else
      sed 's/^/    /' "$log.short"
      echo "    (all of it: $log)"
    fi
  fi
done

if [[ ${#failures[@]} -gt 0 ]]; then
  echo "check: ${#failures[@]} of ${#wanted[@]} checks failed: ${failures[*]}"
  exit 1
fi
echo "check: all ${#wanted[@]} checks passed"
