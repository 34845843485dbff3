#!/usr/bin/env bash
# Feeds the readers of clouds and map files with what no sensor and no disk would: `scripts/fuzz.sh [seconds of each] [name]...`
# Installs clang where it is missing. Stops at the first finding and says where it lies.
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

seconds=${1:-60}
shift || true
build=$workspace/fuzz

fuzzer_runtime=$(ls /usr/lib/llvm-*/lib/clang/*/lib/linux/libclang_rt.fuzzer-x86_64.a 2>/dev/null || true)
if [[ -z $fuzzer_runtime ]] || ! command -v clang++ >/dev/null; then
  as_root=()
  if [[ $EUID -ne 0 ]]; then as_root=(sudo); fi
  "${as_root[@]}" apt-get -q install -y --no-install-recommends clang libclang-rt-14-dev </dev/null ||
    "${as_root[@]}" apt-get -q install -y --no-install-recommends clang </dev/null  # which brings them on Ubuntu 20.04
fi
cmake -S "$repository" -B "$build" "${compiler_cache[@]}" -DCMAKE_BUILD_TYPE=RelWithDebInfo -DCMAKE_CXX_COMPILER=clang++ \
  -DATOM_MAPPING_CORE_ONLY=ON -DATOM_MAPPING_FUZZ=ON -DATOM_MAPPING_SANITIZE=fuzzer-no-link,address,undefined -DPYTHON_EXECUTABLE=/usr/bin/python3 >"$build.log"
cmake --build "$build" -j "$jobs" --target make_corpus cloud_conversion_fuzz map_file_fuzz map_stream_fuzz

names=("$@")
[[ $# -gt 0 ]] || names=(cloud_conversion map_file map_stream)
for name in "${names[@]}"; do
  echo "=== $name: $seconds s"
  mkdir -p "$build/found/$name" "$build/corpus/$name"
  # What a file claims must not take more memory or time than it can be worth.
  "$build/${name}_fuzz" "$build/corpus/$name" "$repository/fuzz/corpus/$name" -max_total_time="$seconds" -max_len=24576 \
    -timeout=90 -report_slow_units=90 -rss_limit_mb=2048 -print_final_stats=1 -artifact_prefix="$build/found/$name/" 2>"$build/$name.log" ||
    { tail -n 60 "$build/$name.log"; echo "$name: a finding, in $build/found/$name"; exit 1; }
  grep -E '^stat::number_of_executed_units|^Done' "$build/$name.log"
done
