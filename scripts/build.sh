#!/usr/bin/env bash
# Builds everything, the tests too, into .workspace. Other targets may be given: `scripts/build.sh install`.
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

if [[ $# -eq 0 ]]; then set -- all tests; fi
cd "$workspace"
# One build at a time: two in one folder destroy each other's files.
exec flock "$workspace/build.lock" catkin_make -j"$jobs" "${compiler_cache[@]}" \
  -DPYTHON_EXECUTABLE=/usr/bin/python3 -DPython3_EXECUTABLE=/usr/bin/python3 "$@"
