#!/usr/bin/env bash
# Repeats the experiments of the paper's section V, OctoMap beside the atoms, and draws tables and plots of what came out.
set -euo pipefail

usage() {
  cat <<'USAGE'
Usage: scripts/reproduce_paper.sh [--quick] [--publish] [--output FOLDER]
  --quick          fewer scans and radii: a check that all works, in some two minutes
  --publish        puts the plots into docs/images and the tables into docs/evaluation.md
  --output FOLDER  for figures (data/*.json), tables.md and plots (default evaluation_output)
Recordings are taken from $ATOM_MAPPING_DATA (default ../shared/data). Let nothing else run: times are measured.
USAGE
}

command="scripts/reproduce_paper.sh${*:+ $*}"
output='' quick=false publish=false
while [[ $# -gt 0 ]]; do
  case $1 in
    --quick) quick=true && shift ;;
    --publish) publish=true && shift ;;
    --output) output=$(realpath -m "${2:?}") && shift 2 ;;
    --help | -h) usage && exit 0 ;;
    *) usage >&2 && exit 2 ;;
  esac
done

# Not before: it may install packages.
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"
output=${output:-$repository/evaluation_output}

# Scans: of the drives of Table I, of those at small radii, of those with exact truth, in the closed scenes, of slopes.
drive=600 fine=100 few=40 closed=40 climb=40
table_radii='0.5 1.0' fine_radii='0.25 0.1' tradeoff_radii='1.0 0.7 0.5 0.35 0.25 0.15 0.1' coverage_radii='1.0 0.5 0.25 0.1'
slopes='0 2.5 5 7.5 10 12.5 15 20' noises='0 0.01' grown=10000000
if $quick; then
  drive=30 fine=8 few=10 climb=20
  fine_radii=0.25 tradeoff_radii='1.0 0.5' coverage_radii=1.0 slopes='0 10 20' noises=0 grown=300000
fi

recordings=${ATOM_MAPPING_DATA:-$repository/../shared/data}
data=$output/data
programs=$workspace/devel/lib/atom_mapping
mkdir -p "$data"
rm -f "$data"/*.json "$data"/*.txt  # of another run
echo "Building, the log is in $output/build.log"
"$repository/scripts/build.sh" simulate_bag compare_maps evaluate_map grow_map >"$output/build.log" 2>&1 ||
  { tail -n 40 "$output/build.log"; exit 1; }

# run NAME PROGRAM ARGUMENTS...: leaves the figures in NAME.json and what was printed in NAME.txt.
run() {
  local name=$1 program=$2 start=$SECONDS
  "$programs/$program" "${@:3}" --json "$data/$name.json" >"$data/$name.txt" 2>"$data/$name.log" ||
    { cat "$data/$name.log"; return 1; }
  rm "$data/$name.log"
  echo "$name: $((SECONDS - start)) s"
}

# Reads lines of arguments of run and runs as many at once as there are cores: where no time is measured.
runTogether() {
  export -f run
  export programs data
  xargs -P "$(nproc)" -L 1 bash -c 'run "$@" || exit 255' run
}

# compare BAG NAME: Table I, and fewer scans at smaller radii.
compare() {
  # shellcheck disable=SC2086
  run "compare_$2" compare_maps --bag "$1" --radius $table_radii --scans "$drive" --pruned --every-return --stride 47
  # shellcheck disable=SC2086
  run "fine_$2" compare_maps --bag "$1" --radius $fine_radii --scans "$fine" --pruned --every-return --stride 13
}

# What was run, and where.
describeRun() {
  local changed=''
  if [[ -n $(git -C "$repository" status --porcelain -- src include cmake scripts) ]]; then changed=' and changes'; fi
  printf '%s\n' "command: \`$command\`" "commit: $(git -C "$repository" rev-parse --short HEAD)$changed" \
    "machine: $(sed -n 's/^model name[[:space:]]*: //p' /proc/cpuinfo | head -n 1), $(nproc) cores, $memory_gb GB free" \
    "system: $(sed -n 's/^PRETTY_NAME="\(.*\)"/\1/p' /etc/os-release), $(c++ --version | head -n 1)" \
    "date: $(date +%F), other programs' load at the start: $(cut -d ' ' -f 1 /proc/loadavg)"
}
describeRun >"$data/run.txt"

echo "Simulating drives of $drive scans"
printf '%s\n' hall campus | xargs -P "$(nproc)" -I{} "$programs/simulate_bag" --scene {} --scans $drive --out "$data/{}.bag"
for scene in hall campus; do
  compare "$data/$scene.bag" $scene
  rm "$data/$scene.bag"
done
for name in handheld street vlp16_room vlp16_dual_return; do
  if [[ -f $recordings/$name.bag ]]; then
    compare "$recordings/$name.bag" $name
  else
    echo "SKIPPED: $recordings/$name.bag is not there, so the tables lack it"
  fi
done
# shellcheck disable=SC2086
run tradeoff evaluate_map --scene hall --radius $tradeoff_radii --scans $few --stride 7 --pruned --every-return
for mode in occupancy signed_distance; do run growth_atom_$mode grow_map --mode $mode --atoms $grown; done

{
  for noise in $noises; do
    for scene in cube cube_rotated sphere; do
      echo "${scene}_$noise evaluate_map --scene $scene --radius 0.1 --scans $closed --noise $noise --stride 7 --picture"
    done
  done
  for scene in hall campus; do
    echo "coverage_$scene evaluate_map --scene $scene --radius $coverage_radii --scans $few --stride 3 --every-return"
  done
  echo "ground evaluate_map --slope $slopes --radius 0.25 --scans $climb --stride 3 --picture"
} | runTogether

"$repository/scripts/plots/write_tables.py" "$data" >"$output/tables.md"
"$repository/scripts/plots/draw_figures.py" "$data" "$output"
if $publish; then
  cp "$output"/evaluation_*.png "$repository/docs/images"
  "$repository/scripts/plots/write_tables.py" "$data" --into "$repository/docs/evaluation.md"
fi
echo "$output/tables.md, $output/evaluation_*.png"
