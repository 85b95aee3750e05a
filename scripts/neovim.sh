#!/usr/bin/env bash
# Unpacks Debian 13's Neovim, which is newer than that of Debian 12, with its libraries, into a folder of the cache, for tests of the
# plugin. Nothing is installed, and it need not be root.
set -euo pipefail

suite=trixie
folder=${XDG_CACHE_HOME:-$HOME/.cache}/proskill/neovim-$suite
[ ! -x "$folder/nvim" ] || exit 0

half=$(mktemp -d)
trap 'rm -rf "$half"' EXIT
mkdir -p "$half"/{apt/lists/partial,apt/cache/archives/partial,root} "$(dirname "$folder")"
: >"$half/apt/status" # nothing counts as installed, so that all libraries come along
echo "deb [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] http://deb.debian.org/debian $suite main" >"$half/apt/sources.list"

apart() {
  apt-get -q -y -o Dir::State="$half/apt" -o Dir::State::status="$half/apt/status" -o Dir::Cache="$half/apt/cache" \
    -o Dir::Etc::SourceList="$half/apt/sources.list" -o Dir::Etc::SourceParts=- -o Debug::NoLocking=1 -o APT::Sandbox::User= \
    -o Acquire::Languages=none -o Acquire::IndexTargets::deb::DEP-11::DefaultEnabled=false -o Acquire::http::Timeout=10 "$@"
}
apart update
apart --download-only --no-install-recommends install neovim
for package in "$half"/apt/cache/archives/*.deb; do dpkg-deb --extract "$package" "$half/root"; done

loader=$(cd "$half/root" && echo usr/lib*/ld-linux-*.so.*)
libraries=$(cd "$half/root" && echo usr/lib/*-linux-gnu)
cat >"$half/root/nvim" <<END
#!/bin/sh
# With its own C library, which a program from a later Debian needs.
here=\$(dirname "\$0")
export VIMRUNTIME="\$here/usr/share/nvim/runtime"
exec "\$here/$loader" --library-path "\$here/$libraries" "\$here/usr/bin/nvim" --cmd "set runtimepath+=\$here/usr/lib/nvim" "\$@"
END
chmod +x "$half/root/nvim"
"$half/root/nvim" --version
rm -rf "$folder"
mv "$half/root" "$folder"
