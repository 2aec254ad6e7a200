#!/usr/bin/env bash
# Installs what the project needs and this machine lacks: Debian 12 packages, as root or through sudo.
# On Ubuntu with ROS Noetic use instead: rosdep install --from-paths src --ignore-src -y
set -euo pipefail

if [[ $# -gt 0 ]]; then
  sed -n '2,3s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"
  [[ "$1" == "--help" || "$1" == "-h" ]] && exit 0
  echo "install_dependencies: takes no arguments, got \"$1\"" >&2
  exit 2
fi

packages=(
  # compiler and the physics libraries
  g++ cmake make libeigen3-dev libyaml-cpp-dev libgtest-dev libbenchmark-dev
  # ROS 1 as Debian ships it
  catkin libroscpp-dev libroslib-dev librosbag-dev libtf2-ros-dev librostest-dev
  ros-message-generation ros-message-runtime libstd-msgs-dev ros-std-msgs
  libros-rosgraph-msgs-dev ros-rosgraph-msgs libdiagnostic-msgs-dev ros-diagnostic-msgs
  python3-std-msgs python3-tf2-msgs python3-geometry-msgs python3-rosgraph-msgs python3-diagnostic-msgs
  python3-roslaunch python3-rostest python3-rosbag python3-rosservice python3-rostopic
  python3-rosnode python3-rosmsg python3-rosparam rosbash
  # rviz with its panels, and a screen that they can be tested on
  rviz librviz-dev pluginlib-dev qtbase5-dev libqwt-qt5-dev
  libvisualization-msgs-dev ros-visualization-msgs python3-visualization-msgs libgeometry-msgs-dev ros-geometry-msgs
  libgl1-mesa-dri xvfb imagemagick
  # figures
  python3-matplotlib python3-yaml
  # build tool and checks that CI runs
  colcon python3-colcon-ros catkin-lint clang-format git
)

missing=()
for package in "${packages[@]}"; do
  dpkg-query -W -f='${Status}\n' "$package" 2>/dev/null | grep -q '^install ok installed$' || missing+=("$package")
done
[ ${#missing[@]} -eq 0 ] && exit 0

command -v apt-get >/dev/null || { echo "install_dependencies: needs apt-get for: ${missing[*]}" >&2; exit 1; }
as_root=()
if [ "$(id -u)" -ne 0 ]; then
  command -v sudo >/dev/null || { echo "install_dependencies: run as root, or install sudo, to add: ${missing[*]}" >&2; exit 1; }
  as_root=(sudo)
fi
log=$(mktemp "${TMPDIR:-/tmp}/install_dependencies.XXXXXX.log")
echo "install_dependencies: adding ${#missing[@]} packages and what they need, some minutes (what apt says: $log): ${missing[*]}"
if ! { "${as_root[@]}" apt-get update -q &&
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends "${missing[@]}"; } > "$log" 2>&1; then
  tail -n 30 "$log" >&2
  echo "install_dependencies: apt-get failed, see above and $log" >&2
  exit 1
fi
rm -f "$log"
