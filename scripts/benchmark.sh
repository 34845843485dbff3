#!/usr/bin/env bash
# Times queries, saving and loading, and forgetting, on a map of a million atoms. Arguments go to Google Benchmark:
# `scripts/benchmark.sh --benchmark_filter=rays`.
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

benchmarks=(query_benchmark map_file_benchmark forget_benchmark)
"$repository/scripts/build.sh" "${benchmarks[@]}" >"$workspace/benchmark.log" 2>&1 ||
  { tail -n 40 "$workspace/benchmark.log"; exit 1; }
for benchmark in "${benchmarks[@]}"; do "$workspace/devel/lib/atom_mapping/$benchmark" "$@"; done
