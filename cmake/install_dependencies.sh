#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Installs the Debian packages that the project needs and that are missing (all of them
# present: no apt call at all). Uses sudo when not root.
# usage: bash cmake/install_dependencies.sh [--tests]
set -euo pipefail

packages=(cmake g++ make libeigen3-dev libpcl-dev libceres-dev libopencv-dev
          libopencv-contrib-dev libvtk9-dev libcli11-dev nlohmann-json3-dev xvfb)
case "${1:-}" in
  "") ;;
  --tests) packages+=(libgtest-dev libgmock-dev parallel openmpi-bin libbenchmark-dev) ;;
  *) echo "usage: bash cmake/install_dependencies.sh [--tests]" >&2; exit 2 ;;
esac

is_installed () {
  [ "$(dpkg-query -W -f '${db:Status-Status}\n' "$1" 2>/dev/null | head -n 1)" = installed ]
}

if ! command -v dpkg-query >/dev/null; then
  echo "install_dependencies: no dpkg here; the needed packages by their Debian names:" \
       "${packages[*]}" >&2
  exit 0
fi

missing=()
for package in "${packages[@]}"; do
  is_installed "$package" || missing+=("$package")
done
if [ ${#missing[@]} -eq 0 ]; then
  echo "Dependencies: all installed."
  exit 0
fi

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  if ! command -v sudo >/dev/null; then
    echo "install_dependencies: as root, run: apt-get install ${missing[*]}" >&2
    exit 1
  fi
  as_root=(sudo)
fi
apt_get () { "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q "$@"; }

is_known () { apt-cache show "$1" >/dev/null 2>&1; }

echo "Dependencies: installing ${missing[*]}"
install=(install -y --no-install-recommends "${missing[@]}")
for package in "${missing[@]}"; do
  if ! is_known "$package"; then
    echo "Dependencies: the package lists do not know $package yet: apt-get update"
    apt_get update
    apt_get "${install[@]}"
    exit 0
  fi
done
if ! apt_get "${install[@]}"; then
  echo "Dependencies: the package lists may be out of date: apt-get update, then again"
  apt_get update
  apt_get "${install[@]}"
fi
