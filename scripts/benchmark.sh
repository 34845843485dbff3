#!/usr/bin/env bash
# Times queries on a map of a million atoms. Arguments go to Google Benchmark: `scripts/benchmark.sh --benchmark_filter=rays`.
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

"$repository/scripts/build.sh" query_benchmark >"$workspace/benchmark.log" 2>&1 || { tail -n 40 "$workspace/benchmark.log"; exit 1; }
exec "$workspace/devel/lib/atom_mapping/query_benchmark" "$@"
