#!/usr/bin/env bash
# chroot.sh 0.20|1.0|1.1: the Python and FreeCAD tests against that FreeCAD, in a Debian of its own
# that starts with nothing installed (12 carries 0.20, 13 carries 1.0, the one after it 1.1).
# Needs root, 3 to 5 GB of disk, and Debian's mirror.
# The system is kept for the next run under $ADVLAYERS_CHROOTS (default /var/tmp/advlayers).
set -euo pipefail

die() {
  printf 'chroot.sh: %s\n' "$*" >&2
  exit 1
}

# Mounts made below live in a mount namespace of this run: they end with it, whatever happens.
if [ "${ADVLAYERS_NAMESPACE:-}" != own ]; then
  [ "$(id -u)" -eq 0 ] || die "needs root: chroot and mount are the superuser's"
  unshare --mount true 2>/dev/null || die "this system does not allow mount namespaces (unshare)"
  ADVLAYERS_NAMESPACE=own exec unshare --mount --propagation private -- "$0" "$@"
fi

case "${1:-}" in
  0.20) suite=bookworm ;;
  1.0) suite=trixie ;;
  1.1) suite=forky ;;
  *) die "FreeCAD 0.20, 1.0 or 1.1, got '${1:-}'" ;;
esac
checkout=$(cd "$(dirname "$(readlink -f "$0")")/../.." && pwd)
root=${ADVLAYERS_CHROOTS:-/var/tmp/advlayers}/$suite

# What this machine's apt was told about its mirror holds for the other system as well.
apt_settings() {
  apt-config dump | grep -E \
    '^Acquire::(Check-Valid-Until|Check-Date|https?::Proxy|https?::Verify-Peer) ' || true
}

mirror() {
  awk '/^URIs:/ {print $2; exit}' /etc/apt/sources.list.d/*.sources 2>/dev/null |
    grep . ||
    awk '$1 == "deb" {for (i = 2; i <= NF; i++) if ($i ~ /^https?:/) {print $i; exit}}' \
      /etc/apt/sources.list /etc/apt/sources.list.d/*.list 2>/dev/null
}

bootstrap() {
  command -v mmdebstrap >/dev/null ||
    apt-get install -y -q --no-install-recommends -o DPkg::Lock::Timeout=300 mmdebstrap ||
    die "mmdebstrap cannot be installed"
  local options=() line uri
  uri=$(mirror) || die "no Debian mirror found in /etc/apt"
  while IFS= read -r line; do
    [ -z "$line" ] || options+=("--aptopt=$line")
  done < <(apt_settings)
  rm -rf --one-file-system "$root"
  mkdir -p "$(dirname "$root")"
  mmdebstrap --variant=apt --mode=root "${options[@]}" \
    --aptopt='APT::Install-Recommends "false"' --aptopt='Acquire::Languages "none"' \
    --dpkgopt='path-exclude=/usr/share/locale/*' \
    "$suite" "$root" "deb $uri $suite main"
  touch "$root/.complete"
}

mount_system() {
  mount -t proc proc "$root/proc"
  mount --rbind /sys "$root/sys"
  mount --rbind /dev "$root/dev"
  mount -t tmpfs tmpfs "$root/tmp"
  cp -fL /etc/resolv.conf "$root/etc/resolv.conf"
}

# The checkout without what was built for this machine; the other system's own build stays.
copy_checkout() {
  mkdir -p "$root/project"
  find "$root/project" -mindepth 1 -maxdepth 1 ! -name build -exec rm -rf {} +
  tar -C "$checkout" --exclude=./build --exclude=./out --exclude=./.git --exclude='_core*.so' \
    -cf - . | tar -C "$root/project" -xf -
}

[ -e "$root/.complete" ] || bootstrap
mount_system
copy_checkout
mkdir -p "$root/usr/share/man/man1"  # some packages' set-up wants it
exec chroot "$root" /usr/bin/env -i HOME=/tmp LANG=C.UTF-8 PATH=/usr/sbin:/usr/bin:/sbin:/bin \
  DEBIAN_FRONTEND=noninteractive bash -c 'cd /project && exec ./dev test --freecad-only'
