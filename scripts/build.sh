#!/usr/bin/env bash
# Installs what is missing and builds the workspace with catkin_make into build/ and devel/, from any directory.
#   scripts/build.sh [ARGUMENT...]     arguments go on to catkin_make, for example -DCMAKE_BUILD_TYPE=Debug, tests, -j1
# JOBS=n sets the number of compilers at once.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/environment.sh"

if [[ "${1:-}" == "--help" || "${1:-}" == "-h" ]]; then
  sed -n '2,4s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"
  exit 0
fi

install_dependencies

if ! catkin_make -C "$REPO" -DCMAKE_BUILD_TYPE=Release -DCMAKE_EXPORT_COMPILE_COMMANDS=ON -DPYTHON_EXECUTABLE="$PYTHON" \
    -j"$(parallel_jobs)" "$@"; then
  echo "build: catkin_make failed, see the first error above. If the checkout was moved or copied since the last build," \
    "remove build/ and devel/ and start again." >&2
  exit 1
fi
echo "build: done. For this shell:  source '$REPO/devel/setup.bash'"
