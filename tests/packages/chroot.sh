#!/usr/bin/env bash
# chroot.sh 12|13|forky: installs the Debian packages, and the wheel, in a Debian that has FreeCAD and
# nothing else of this project; times the way to the first layered mesh; upgrades and removes.
# For another Debian than this one the packages are built there first. Needs root, and Debian's mirror.
set -euo pipefail

die() {
  printf 'chroot.sh: %s\n' "$*" >&2
  exit 1
}

# Mounts made below live in a mount namespace of this run: they end with it, whatever happens.
if [ "${ADVLAYERS_NAMESPACE:-}" != own ]; then
  [ "$(id -u)" -eq 0 ] || die "needs root: chroot and mount are the superuser's"
  ADVLAYERS_NAMESPACE=own exec unshare --mount --propagation private -- "$0" "$@"
fi
case "${1:-}" in
  12) suite=bookworm ;;
  13) suite=trixie ;;
  forky) suite=forky ;;
  *) die "Debian 12, 13 or forky, got '${1:-}'" ;;
esac
checkout=$(cd "$(dirname "$(readlink -f "$0")")/../.." && pwd)
root=${ADVLAYERS_CHROOTS:-/var/tmp/advlayers}/fresh-$suite

mirror() {
  awk '/^URIs:/ {print $2; exit}' /etc/apt/sources.list.d/*.sources 2>/dev/null | grep . ||
    awk '$1 == "deb" {for (i = 2; i <= NF; i++) if ($i ~ /^https?:/) {print $i; exit}}' \
      /etc/apt/sources.list /etc/apt/sources.list.d/*.list 2>/dev/null
}

if [ ! -e "$root/.complete" ]; then
  command -v mmdebstrap >/dev/null || apt-get install -y -q --no-install-recommends mmdebstrap
  rm -rf --one-file-system "$root"
  mkdir -p "$(dirname "$root")"
  options=()
  while IFS= read -r line; do options+=("--aptopt=$line"); done < <(apt-config dump |
    grep -E '^Acquire::(Check-Valid-Until|Check-Date|https?::Proxy|https?::Verify-Peer) ' || true)
  mmdebstrap --variant=apt --mode=root "${options[@]}" --include=freecad,freecad-python3 \
    --aptopt='APT::Install-Recommends "false"' --aptopt='Acquire::Languages "none"' \
    "$suite" "$root" "deb $(mirror) $suite main"
  touch "$root/.complete"
fi
mount -t proc proc "$root/proc"
mount --rbind /dev "$root/dev"
mount -t tmpfs tmpfs "$root/tmp"
cp -fL /etc/resolv.conf "$root/etc/resolv.conf"
inside() {
  chroot "$root" /usr/bin/env -i HOME=/tmp LANG=C.UTF-8 PATH=/usr/sbin:/usr/bin:/sbin:/bin \
    DEBIAN_FRONTEND=noninteractive "$@"
}

mkdir -p "$root/tmp/dist"
if [ "$suite" = "$(. /etc/os-release && echo "$VERSION_CODENAME")" ]; then
  cp "$checkout"/out/dist/*.deb "$root/tmp/dist/"
else
  mkdir -p "$root/project"
  tar -C "$checkout" --exclude=./build --exclude=./out --exclude=./.git --exclude='_core*.so' \
    -cf - . | tar -C "$root/project" -xf -
  inside bash -c 'cd /project && ./dev package'
  cp "$root"/project/out/dist/*.deb "$root/tmp/dist/"
fi
cp "$checkout/tests/data/cylinder.brep" "$root/tmp/"
cat >"$root/tmp/job.json" <<'JSON'
{ "input": "cylinder.brep", "size": 4, "first_height": 0.3, "outputs": ["c.vtu", "c.FCStd"] }
JSON

begin=$(date +%s)
inside apt-get install -y -q --no-install-recommends /tmp/dist/freecad-advancing-layers_*.deb \
  /tmp/dist/python3-advlayers-core_*.deb
inside advlayers job /tmp/job.json
printf 'from the first command to the first layered mesh: %d s\n' $(($(date +%s) - begin))
inside advlayers version
inside dpkg -i /tmp/dist/python3-advlayers-core_*.deb /tmp/dist/freecad-advancing-layers_*.deb
inside freecadcmd -c "import advlayers; assert advlayers.__file__.startswith('/usr/share/freecad')"
inside apt-get purge -y -q --autoremove freecad-advancing-layers python3-advlayers-core
inside find /usr -xdev | grep -i -E 'advlayers|advancing' && die "left behind, see above"
printf 'chroot.sh: %s passed\n' "$suite"
