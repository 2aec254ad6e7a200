# shellcheck shell=bash
# What all scripts have in common. To be sourced:  source "$(dirname "${BASH_SOURCE[0]}")/environment.sh"
# Gives REPO (the checkout, absolute), PYTHON, and the functions below. Changes PATH, and on Ubuntu what ROS's setup.bash changes.

if [[ "${BASH_SOURCE[0]}" == "$0" ]]; then
  echo "environment.sh is sourced by the other scripts; run scripts/build.sh, test.sh, check.sh or demo.sh" >&2
  exit 1
fi

REPO="$(CDPATH='' cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)"

# ROS is built for the system's Python. Another python3 first on PATH (pyenv, conda) breaks catkin_make and every node
# that starts with "env python3".
# shellcheck disable=SC2034  # for the scripts that source this file
PYTHON=/usr/bin/python3
case "$PATH" in
  /usr/bin:*) ;;
  *) export PATH="/usr/bin:$PATH" ;;
esac

# source_setup FILE: sources a setup file of ROS, catkin or colcon. They use unset variables, so not under `set -u`, and
# they read the positional parameters, so the caller's must not reach them.
source_setup() {
  local setup_file=$1 had_nounset=0
  shift
  [[ $- == *u* ]] && had_nounset=1
  set +u
  # shellcheck disable=SC1090
  source "$setup_file"
  [[ $had_nounset -eq 0 ]] || set -u
}

# Debian has ROS 1 in /usr, which needs no setup file; Ubuntu 20.04 has it in /opt/ros/noetic.
NOETIC_SETUP=/opt/ros/noetic/setup.bash
if [[ -f "$NOETIC_SETUP" ]]; then
  source_setup "$NOETIC_SETUP"
fi

install_dependencies() {
  if [[ -f "$NOETIC_SETUP" ]]; then
    return 0  # Ubuntu: `rosdep install --from-paths src --ignore-src -y`, once, by hand: it asks for sudo and the network
  fi
  "$REPO/scripts/install_dependencies.sh"
}

# How many compilers at once: one a processor, as far as memory goes (a file that includes Eigen and roscpp takes up to
# 1.5 GB). JOBS=n overrules.
parallel_jobs() {
  local processors available_kb limit_bytes jobs
  if [[ -n "${JOBS:-}" ]]; then
    echo "$JOBS"
    return
  fi
  processors=$(nproc)
  available_kb=$(awk '/^MemAvailable:/ { print $2 }' /proc/meminfo)
  if [[ -r /sys/fs/cgroup/memory.max ]]; then  # a container may be allowed less than the machine has
    limit_bytes=$(cat /sys/fs/cgroup/memory.max)
    if [[ "$limit_bytes" =~ ^[0-9]+$ ]] && ((limit_bytes / 1024 < available_kb)); then
      available_kb=$((limit_bytes / 1024))
    fi
  fi
  jobs=$((available_kb / 1500000))
  ((jobs <= processors)) || jobs=$processors
  ((jobs >= 1)) || jobs=1
  echo "$jobs"
}
