#!/usr/bin/env bash
# scripts/fresh.sh [demo|test]: the README's two commands, or one of them, on a Debian 12 that has nothing but git, made
# here from this system's mirror and thrown away again. What is tried is the commit, not what is not committed yet.
set -euo pipefail
cd "$(dirname "$0")/.."
commands=("${@:-demo test}")
read -ra commands <<<"${commands[*]}"
[ "$(id -u)" -eq 0 ] || { echo "./dev fresh makes a system of its own: run it as root" >&2; exit 1; }

cache=build/fresh root=$PWD/build/fresh/root.$$
mkdir -p "$cache"
trap 'rm -rf --one-file-system "$root" "$root.tar"' EXIT

# Debian's mirrors and proxy, from apt's configuration.
mirrors() {
  apt-get indextargets --format '$(ORIGIN) deb $(REPO_URI) $(RELEASE) $(COMPONENT)' 'Created-By: Packages' |
    sed -n 's/^Debian \(.* bookworm.*\)/\1/p' | sort -u
}
network() { apt-config dump | grep -E '^Acquire::(http|https|ftp|Check-Date|Check-Valid-Until)(::| )' || true; }

# makeBase: builds a minimal system with git. It is kept for a week, since it does not depend on this tree.
makeBase() {
  find "$cache" -name base.tar -mtime +7 -delete
  if [ -e "$cache/base.tar" ]; then
    echo "the bare system is that of $(date -r "$cache/base.tar" +%F\ %R), unpacked again"
    return
  fi
  local options=()
  while read -r line; do options+=(--aptopt="${line%;}"); done < <(network)
  mirrors | mmdebstrap --quiet --variant=minbase --include=ca-certificates,git "${options[@]}" bookworm "$root.tar" -
  mv "$root.tar" "$cache/base.tar"
}

# A minimal system lacks the host names and certificates of this network.
connect() {
  cp --dereference /etc/resolv.conf /etc/hosts "$root/etc/"
  if compgen -G '/usr/local/share/ca-certificates/*.crt' >/dev/null; then
    cp /usr/local/share/ca-certificates/*.crt "$root/usr/local/share/ca-certificates/"
    chroot "$root" update-ca-certificates >/dev/null 2>&1
  fi
}

# inside COMMAND…: runs it in the minimal system, with no environment but the proxies. Mounts and processes end with it.
inside() {
  local proxies=() name
  for name in http_proxy https_proxy no_proxy; do [ -z "${!name:-}" ] || proxies+=("$name=${!name}"); done
  unshare --mount --pid --fork --kill-child bash -euc '
    mount -t proc proc "$0/proc"
    mount -t sysfs -o ro sysfs "$0/sys"
    mount --rbind /dev "$0/dev"
    exec chroot "$0" "$@"' "$root" env -i PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin \
    HOME=/root LANG=C.UTF-8 TERM=dumb ${CI:+CI="$CI"} "${proxies[@]}" "$@"
}

took=()
# timed NAME COMMAND…
timed() {
  local begin=$SECONDS status=0
  "${@:2}" || status=$?
  took+=("$(printf '%6d s  %s%s' $((SECONDS - begin)) "$1" "$([ $status -eq 0 ] || echo " (FAILED, $status)")")")
  return $status
}

timed "a bare Debian 12" makeBase
mkdir "$root"
tar -xf "$cache/base.tar" -C "$root"
connect
commit=$(git rev-parse HEAD)
git bundle create --quiet "$root/tmp/tree.bundle" HEAD
inside git -c advice.detachedHead=false clone --quiet /tmp/tree.bundle /root/proskill

failed=0
for command in "${commands[@]}"; do
  echo "=== ./dev $command"
  timed "./dev $command" inside bash -c "cd /root/proskill && ./dev $command" || failed=1
done
echo
echo "${commit:0:12} on a bare Debian $(cat "$root/etc/debian_version"), $(nproc) cores:"
printf '%s\n' "${took[@]}"
exit $failed
