#!/usr/bin/env bash
# Runs the node for some minutes under all that a robot asks of it at once, and judges it:
# `scripts/soak.sh [MINUTES] [--light] [--map FILE]`; --light: instead of all one client of 100 queries a second, who listens
# to ~atoms, and rviz where there is Xvfb; --map: a map to start from.
# Figures and memory over time land in .workspace/soak; the last line is the verdict, and the result 0 if it passed.
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

minutes=30 light=() node_arguments=()
while [[ $# -gt 0 ]]; do
  case $1 in
    --light) light=(--light) && shift ;;
    --map) node_arguments=("_storage/load:=$(realpath "${2:?}")") && shift 2 ;;
    *) minutes=$1 && shift ;;
  esac
done
output=$workspace/soak
mkdir -p "$output"
if [[ ${BUILD:-yes} == yes ]]; then
  "$repository/scripts/build.sh" all >"$output/build.log" 2>&1 || { tail -n 40 "$output/build.log"; exit 1; }
fi
sourceUnchecked "$workspace/devel/setup.bash"
programs=$workspace/devel/lib/atom_mapping
if [[ ! -f $output/hall.bag ]]; then
  "$programs/simulate_bag" --scene hall --scans 600 --out "$output/hall.bag.part" >/dev/null
  mv "$output/hall.bag.part" "$output/hall.bag"
fi

export ROS_HOME=$workspace/ros_home ROS_HOSTNAME=localhost ROS_MASTER_URI=http://localhost:$((20000 + RANDOM % 10000))
pids=()
stopAll() { for pid in "${pids[@]}"; do kill "$pid" 2>/dev/null || true; done; wait; }
trap stopAll EXIT
roscore -p "${ROS_MASTER_URI##*:}" >"$output/roscore.log" 2>&1 &
pids+=($!)
until rosparam set /use_sim_time true 2>/dev/null; do sleep 0.2; done
if [[ ${#light[@]} -eq 0 ]]; then
  # A folder of its own: what the last soak saved may be the map to start from.
  node_arguments+=("_storage/autosave:=$(mktemp -d "$output/autosave.XXXX")/map.h5" _storage/autosave_period:=5.0)
fi
"$programs/atom_mapping_node" cloud_in:=/velodyne_points __name:=atom_mapping "${node_arguments[@]}" >"$output/node.log" 2>&1 &
node=$!
pids+=("$node")
if [[ ${#light[@]} -gt 0 ]] && command -v Xvfb >/dev/null; then
  rm -f "$output/display"
  Xvfb -screen 0 1280x800x24 -displayfd 3 3>"$output/display" >/dev/null 2>&1 &
  pids+=($!)
  until [[ -s $output/display ]]; do sleep 0.1; done
  DISPLAY=:$(<"$output/display") LIBGL_ALWAYS_SOFTWARE=1 rviz -d "$repository/rviz/atom_mapping.rviz" >"$output/rviz.log" 2>&1 &
  pids+=($!)
elif [[ ${#light[@]} -gt 0 ]]; then
  echo 'SKIPPED: rviz, since Xvfb is not installed'
fi
/usr/bin/python3 "$repository/scripts/soak/soak.py" "${light[@]}" --bag "$output/hall.bag" --minutes "$minutes" --node "$node" \
  --output "$output"
