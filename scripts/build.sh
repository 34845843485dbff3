#!/usr/bin/env bash
# Builds everything, the tests too, into .workspace. Further arguments go to catkin_make, e.g. `scripts/build.sh install`.
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

# A unit that includes PCL or roscpp takes up to 2 GB.
memory_gb=$(awk '/MemAvailable/ { print int($2 / 1048576) }' /proc/meminfo)
jobs=$((memory_gb / 2 < $(nproc) ? memory_gb / 2 : $(nproc)))
jobs=$((jobs > 1 ? jobs : 1))

cmake_arguments=(-DPYTHON_EXECUTABLE=/usr/bin/python3 -DPython3_EXECUTABLE=/usr/bin/python3)
if command -v ccache >/dev/null; then cmake_arguments+=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache); fi

cd "$workspace"
exec 9>"$workspace/build.lock"
flock 9
if [[ $# -eq 0 ]]; then set -- all tests; fi
catkin_make -j"$jobs" "${cmake_arguments[@]}" "$@" 9>&-
