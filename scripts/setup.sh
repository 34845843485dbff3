#!/usr/bin/env bash
# Makes the machine ready: installs the apt packages that are missing (nothing to do: no network, no sudo) and lays out
# the workspace. Other scripts source it for the variables and the ROS environment; running it alone does no harm.
set -euo pipefail

repository=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
workspace=$repository/.workspace
# catkin runs its tests by unquoted paths.
if [[ $workspace == *[[:space:]]* ]]; then
  workspace=${XDG_CACHE_HOME:-$HOME/.cache}/atom_mapping_$(cksum <<<"$repository" | cut -d ' ' -f 1)
fi

# The system's own Python before a pyenv or conda, which know nothing of catkin.
export PATH=/usr/bin:$PATH

installMissingPackages() {
  local column=2 installed missing
  if grep -qs '^VERSION_CODENAME=focal' /etc/os-release; then column=3; fi
  installed=$(dpkg-query -W -f='${db:Status-Status} ${Package}\n' | awk '$1 == "installed" { print $2 }')
  missing=$(awk -v column=$column '!/^#/ && NF && $column != "-" { print $column }' "$repository/scripts/apt_packages.txt" |
    sort -u | grep -vxF "$installed") || return 0
  echo "Installing:" $missing
  local as_root=()
  if [[ $EUID -ne 0 ]]; then as_root=(sudo); fi
  "${as_root[@]}" apt-get -q update
  # shellcheck disable=SC2086
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q install -y --no-install-recommends $missing </dev/null
}

# The setup files of ROS and catkin read variables that need not be set.
sourceUnchecked() {
  set +u
  # shellcheck disable=SC1090
  source "$1"
  set -u
}

# The package in the workspace: links to all that the repository holds but the workspace itself, in which rosrun, who follows
# links, would go round in a circle. package.xml is a copy, since CMake would install the link.
layOutPackage() {
  local package=$workspace/src/atom_mapping entry name
  if [[ -L $package ]]; then rm "$package"; fi
  mkdir -p "$package"
  find "$package" -mindepth 1 -maxdepth 1 -xtype l -delete
  for entry in "$repository"/* "$repository"/.[!.]*; do
    name=${entry##*/}
    if [[ $name == package.xml ]]; then
      cmp -s "$entry" "$package/$name" || cp "$entry" "$package/$name"
    elif [[ $name != .git && $name != .workspace && ! -e $package/$name ]]; then
      ln -s "$entry" "$package/$name"
    fi
  done
}

installMissingPackages
if [[ -f /opt/ros/noetic/setup.bash ]]; then sourceUnchecked /opt/ros/noetic/setup.bash; fi
layOutPackage

# How many units are compiled at once: one that includes PCL or roscpp takes up to 2 GB.
memory_gb=$(awk '/MemAvailable/ { print int($2 / 1048576) }' /proc/meminfo)
jobs=$((memory_gb / 2 < $(nproc) ? memory_gb / 2 : $(nproc)))
jobs=${JOBS:-$((jobs > 1 ? jobs : 1))}

# Another clone of the repository finds in the cache what this one compiled.
export CCACHE_BASEDIR=$repository CCACHE_NOHASHDIR=1
compiler_cache=()
if command -v ccache >/dev/null; then compiler_cache=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache); fi
