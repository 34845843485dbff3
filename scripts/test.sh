#!/usr/bin/env bash
# Every check there is: set-up, build, format, lint, tests, the core's tests under sanitizers. Ends with the line
# `N passed, N failed`. When nothing changed since all passed it only says so; `--again` repeats everything.
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"
cd "$repository"

export ATOM_MAPPING_DATA=${ATOM_MAPPING_DATA:-$repository/../shared/data}
export ROS_HOME=$workspace/ros_home
export ROS_HOSTNAME=localhost
report=$workspace/test_report.txt
builds=()
outcomes=()

# Names and contents of all that can change an outcome.
fingerprint() {
  { git ls-files -z --cached --others --exclude-standard | grep -zv '\.md$' | xargs -0 sha1sum 2>/dev/null || true
    ls -l "$ATOM_MAPPING_DATA" 2>/dev/null || true
    dpkg-query -W | sha1sum
  } | sha1sum
}

# Runs a check, goes on when it fails, and remembers which.
check() {
  local name=$1 start=$SECONDS outcome=passed
  shift
  echo "=== $name"
  "$@" || outcome=failed
  echo "=== $name: $outcome after $((SECONDS - start)) s"
  outcomes+=("--$outcome=$name")
  [[ $outcome == passed ]]
}

cppFiles() { git ls-files --cached --others --exclude-standard '*.cpp' '*.h'; }

# Of what is compiled now, which is all of it on a new machine, and again after it warned. Of the compiler that this is made
# with: others warn of other things.
buildWithoutWarnings() {
  local log=$workspace/build_output.txt
  scripts/build.sh 2>&1 | tee "$log" || return 1
  [[ $(g++ -dumpversion) == 12 ]] && grep -F 'warning:' "$log" || return 0
  find "$workspace/build" -name '*.o' -delete
  return 1
}

checkFormat() { cppFiles | xargs -d '\n' clang-format --dry-run -Werror; }

checkLint() { catkin_lint --offline --strict "$repository"; }

# A source is checked again when its object file was, that is when anything it includes has changed.
checkTidy() {
  local stamps=$workspace/tidy objects=$workspace/build/atom_mapping/CMakeFiles stale=() source stamp
  mkdir -p "$stamps"
  while read -r source; do
    if ! grep -qF "/$source\"" "$workspace/build/compile_commands.json"; then
      echo "SKIPPED: $source, which is not built here"
      continue
    fi
    stamp=$stamps/${source//\//_}
    if [[ ! $stamp -nt .clang-tidy || $(find "$objects" -path "*/$source.o" -newer "$stamp") ]]; then stale+=("$source"); fi
  done < <(find src -name '*.cpp')
  [[ ${#stale[@]} -eq 0 ]] || printf '%s\n' "${stale[@]}" | xargs -d '\n' -P "$jobs" -I{} bash -c '
    clang-tidy --quiet -p "$0/build" "$0/src/atom_mapping/{}" 2>/dev/null && name={} && touch "$1/${name//\//_}"' \
    "$workspace" "$stamps"
}

# rostests run one after another, since they measure time. Make's own result says nothing of the tests.
checkTests() {
  rm -rf "$workspace/build/test_results"
  scripts/build.sh run_tests_atom_mapping_gtest run_tests_atom_mapping_structure
  JOBS=1 scripts/build.sh run_tests_atom_mapping_rostest
  catkin_test_results "$workspace/build/test_results"
}

# checkSanitized SANITIZERS [OPTION]...: builds the core and its tests with asserts and runs them.
checkSanitized() {
  local build=$workspace/sanitize/$1
  rm -rf "$build/test_results"
  cmake -S "$repository" -B "$build" "${compiler_cache[@]}" -DCMAKE_BUILD_TYPE=RelWithDebInfo \
    -DATOM_MAPPING_CORE_ONLY=ON "-DATOM_MAPPING_SANITIZE=$1" -DPYTHON_EXECUTABLE=/usr/bin/python3 "${@:2}" >"$build.log" || { cat "$build.log"; return 1; }
  cmake --build "$build" -j "$jobs" || return 1
  builds+=("$build")
  # The thread sanitizer of GCC 12 does not bear the address space layout of newer kernels.
  (cd "$build" && setarch -R ctest -j "$jobs" --timeout 900 --output-on-failure)
}

before=$(fingerprint)
if [[ ${1:-} != --again && -f $report && $(head -n 1 "$report") == "$before" ]]; then
  echo "Nothing changed since all passed, $(date -r "$report"). scripts/test.sh --again repeats everything."
  tail -n 1 "$report"
  exit 0
fi
rm -f "$report"

check format checkFormat || true
check lint checkLint || true
if check build buildWithoutWarnings; then
  sourceUnchecked "$workspace/devel/setup.bash"
  builds+=("$workspace/build")
  check tests checkTests || true
  check tidy checkTidy || true
fi
mkdir -p "$workspace/sanitize"
check "tests under the address and undefined behaviour sanitizers" checkSanitized address,undefined || true
# With the server's threads; their messages' headers are of the build above.
check "tests under the thread sanitizer" checkSanitized thread "-DATOM_MAPPING_MESSAGES=$workspace/devel/include" || true

summary=$(scripts/count_tests.py "${builds[@]}" "${outcomes[@]}") || { echo "$summary"; exit 1; }
echo "$summary"
if [[ $(fingerprint) == "$before" ]]; then printf '%s\n%s\n' "$before" "$summary" >"$report"; fi
