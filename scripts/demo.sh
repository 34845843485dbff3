#!/usr/bin/env bash
# From nothing to a map: sets up, builds, simulates a drive with a VLP-16, maps it and draws demo_output/map.png.
set -euo pipefail

usage() {
  cat <<'USAGE'
Usage: scripts/demo.sh [--scene NAME] [--bag FILE [--topic TOPIC]] [--radius METRES] [--rviz]
  --scene NAME     scene to drive through: hall (default), campus, ...
  --bag FILE       a recording to map instead, with the clouds' tf
  --topic TOPIC    of its clouds (default /velodyne_points)
  --radius METRES  of the atoms (default 0.25)
  --rviz           play the bag into the node and watch in rviz, instead of mapping it at full speed
USAGE
}

scene=hall scans=1200 bag='' topic=/velodyne_points radius=0.25 rviz=false
while [[ $# -gt 0 ]]; do
  case $1 in
    --scene) scene=${2:?} && shift 2 ;;
    --bag) bag=$(realpath -m "${2:?}") && shift 2 ;;
    --topic) topic=${2:?} && shift 2 ;;
    --radius) radius=${2:?} && shift 2 ;;
    --rviz) rviz=true && shift ;;
    --help | -h) usage && exit 0 ;;
    *) usage >&2 && exit 2 ;;
  esac
done

if [[ -n $bag && ! -f $bag ]]; then
  echo "demo.sh: there is no file $bag; give --bag the name of a recording" >&2
  exit 2
fi

# Not before: it may install packages.
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"
output=$repository/demo_output
mkdir -p "$output"
echo "Building, the log is in demo_output/build.log"
"$repository/scripts/build.sh" all >"$output/build.log" 2>&1 || { tail -n 40 "$output/build.log"; exit 1; }
sourceUnchecked "$workspace/devel/setup.bash"
programs=$workspace/devel/lib/atom_mapping

# isCurrent FILE OTHER...: FILE exists and is newer than the others.
isCurrent() {
  local other
  for other in "${@:2}"; do [[ $1 -nt $other ]] || return 1; done
}

if [[ -z $bag ]]; then
  bag=$output/$scene.bag
  if ! isCurrent "$bag" "$programs/simulate_bag"; then
    echo "Simulating a drive of two minutes: $bag"
    "$programs/simulate_bag" --scene "$scene" --scans $scans --out "$bag.part" >/dev/null
    mv "$bag.part" "$bag"
  fi
fi

if $rviz; then
  export ROS_HOME=$workspace/ros_home
  exec roslaunch atom_mapping demo.launch bag:="$bag" cloud_topic:="$topic" radius:="$radius"
fi

config=$repository/config/atom_mapping.yaml
atoms=$output/atoms.ply
inputs="$bag $topic $radius"
if ! isCurrent "$atoms" "$bag" "$config" "$programs/atom_mapping_offline" || [[ $(cat "$output/inputs.txt") != "$inputs" ]]; then
  "$programs/atom_mapping_offline" --bag "$bag" --topic "$topic" --radius "$radius" --config "$config" --export "$atoms"
  echo "$inputs" >"$output/inputs.txt"
fi
if [[ -x $programs/render_map ]]; then
  "$programs/render_map" "$atoms" --out "$output/map.png"
  echo "The map: $output/map.png, its atoms: $atoms"
else
  echo "SKIPPED: the picture of the map, which needs VTK 9 (Debian 12); the atoms: $atoms"
fi
