#!/usr/bin/env bash
# Builds everything, the tests too, into .workspace. Other targets may be given: `scripts/build.sh install`.
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

if [[ $# -eq 0 ]]; then set -- all tests; fi
cd "$workspace"
# One build and one target at a time: two at once write the same files.
exec 9>"$workspace/build.lock"
flock 9
for target in "$@"; do
  catkin_make -j"$jobs" "${compiler_cache[@]}" -DPYTHON_EXECUTABLE=/usr/bin/python3 -DPython3_EXECUTABLE=/usr/bin/python3 \
    "$target" 9>&-
done
