#!/usr/bin/env bash
# Builds `proskill` for arm64 on amd64, with Debian's cross compiler, and leaves it in build/arm64/bin/. What it links with is
# unpacked below build/arm64/sysroot: nothing of another architecture is installed on this system.
#   scripts/arm64.sh
set -euo pipefail
cd "$(dirname "$0")/.."

root=$PWD/build/arm64/sysroot
state=$PWD/build/arm64/apt
triple=aarch64-linux-gnu
# The packages that the program is built with; the rest comes with them.
packages=(libc6 libstdc++6 libgraphviz-dev libtree-sitter-dev libutf8proc-dev libxxhash-dev libfmt-dev libcli11-dev nlohmann-json3-dev libasio-dev)

# apt ARGUMENT…: apt-get of a system of this architecture that has nothing installed.
apt() {
  apt-get -q -o APT::Architecture=arm64 -o APT::Architectures=arm64 -o Dir::State="$state/state" -o Dir::State::status="$state/status" \
    -o Dir::Cache="$state/cache" -o APT::Install-Recommends=false -o Debug::NoLocking=true -o APT::Sandbox::User=root "$@"
}

# Each package's files, and a list of which file is whose.
unpack() {
  [ -e "$root/complete" ] && return
  rm -rf "$root"
  mkdir -p "$root" "$state/state/lists/partial" "$state/cache/archives/partial"
  : >"$state/status"
  apt update
  apt --yes --download-only install "${packages[@]}"
  local deb
  for deb in "$state"/cache/archives/*.deb; do
    dpkg-deb --extract "$deb" "$root"
    dpkg-deb --contents "$deb" | awk -v name="$(dpkg-deb --field "$deb" Package)" '!/\/$/ { print substr($6, 2) "\t" name }' >>"$root/files"
  done
  # Links to the root of a system lead into this one.
  find "$root" -type l -lname '/*' -print0 | while IFS= read -r -d '' link; do ln -snf "$root$(readlink "$link")" "$link"; done
  touch "$root/complete"
}

unpack
export PKG_CONFIG_SYSROOT_DIR=$root PKG_CONFIG_LIBDIR=$root/usr/lib/$triple/pkgconfig:$root/usr/share/pkgconfig
cmake --preset program -B build/arm64 --toolchain "$PWD/cmake/Arm64.cmake" -D PROSKILL_SYSROOT="$root" >/dev/null
cmake --build build/arm64 --target proskill
file build/arm64/bin/proskill
