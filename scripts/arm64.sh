#!/usr/bin/env bash
# Builds `proskill` for arm64 on amd64 with Debian's cross compiler, into build/arm64/bin/. The libraries are unpacked in build/arm64/sysroot; no
# package of another architecture is installed on this system.
#   scripts/arm64.sh
set -euo pipefail
cd "$(dirname "$0")/.."

root=$PWD/build/arm64/sysroot
state=$PWD/build/arm64/apt
triple=aarch64-linux-gnu
# Packages that the program is built with; apt adds their dependencies.
packages=(libc6 libstdc++6 libgraphviz-dev libtree-sitter-dev libutf8proc-dev libxxhash-dev libexpat1-dev libfmt-dev libcli11-dev nlohmann-json3-dev libasio-dev)

# apt ARGUMENT…: runs apt-get for a system of this architecture without installed packages.
apt() {
  apt-get -q -o APT::Architecture=arm64 -o APT::Architectures=arm64 -o Dir::State="$state/state" -o Dir::State::status="$state/status" \
    -o Dir::Cache="$state/cache" -o APT::Install-Recommends=false -o Debug::NoLocking=true -o APT::Sandbox::User=root "$@"
}

# Unpacks each package, and lists its files.
unpack() {
  [ -e "$root/complete" ] && return
  rm -rf "$root"
  mkdir -p "$root" "$state/state/lists/partial" "$state/cache/archives/partial"
  : >"$state/status"
  apt update
  apt --yes --download-only install "${packages[@]}"
  local deb name
  for deb in "$state"/cache/archives/*.deb; do
    name=$(dpkg-deb --field "$deb" Package)
    [ "$name" != libc6-dev ] || continue # the cross compiler has its own
    dpkg-deb --extract "$deb" "$root"
    dpkg-deb --contents "$deb" | awk -v name="$name" '!/\/$/ { print substr($6, 2) "\t" name }' >>"$root/files"
  done
  # Makes absolute links relative to the sysroot.
  find "$root" -type l -lname '/*' -print0 | while IFS= read -r -d '' link; do ln -snf "$root$(readlink "$link")" "$link"; done
  touch "$root/complete"
}

unpack
export PKG_CONFIG_SYSROOT_DIR=$root PKG_CONFIG_LIBDIR=$root/usr/lib/$triple/pkgconfig:$root/usr/share/pkgconfig
cmake --preset program -B build/arm64 --toolchain "$PWD/cmake/Arm64.cmake" -D PROSKILL_SYSROOT="$root" >/dev/null
cmake --build build/arm64 --target proskill
file build/arm64/bin/proskill
# It runs, and decides what it decides elsewhere.
qemu-aarch64 -L "$root" build/arm64/bin/proskill verify examples/rover/rover.proskill
