#!/usr/bin/env bash
# Installs everything headland needs on Debian 12, by apt. Idempotent; silent when nothing is missing.
# Run as root or as a user with sudo.
set -euo pipefail

packages=(
  # build
  g++ cmake ninja-build pkg-config ccache git
  # checks
  clang-format-14 clang-tidy-14
  # physics and linear algebra
  libbullet-dev libeigen3-dev
  # maps, geometry, curves
  libgdal-dev libgeos-dev libompl-dev
  # numerics
  libboost-dev libtbb-dev libpagmo-dev
  # files and the command line
  liburdfdom-dev libtinyxml-dev libpugixml-dev libyaml-cpp-dev nlohmann-json3-dev libcli11-dev libfmt-dev
  # runs as data
  libsqlite3-dev libssl-dev zlib1g-dev
  # pictures; EGL is the other maker of the OpenGL context (HEADLAND_GL=EGL)
  libosmesa6-dev libegl-dev libopengl-dev libassimp-dev libpng-dev libwebp-dev libfreetype-dev fonts-dejavu-core gnuplot-nox ffmpeg
  # tests and benchmarks; the browser is for the report's page
  libgtest-dev libgmock-dev librapidcheck-dev libbenchmark-dev chromium
)

# Other ways to install these two bring both at once.
command -v node >/dev/null || packages+=(nodejs)
command -v npm >/dev/null || packages+=(npm)

missing=()
for package in "${packages[@]}"; do
  status=$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null || true)
  [ "$status" = installed ] || missing+=("$package")
done
[ ${#missing[@]} -eq 0 ] && exit 0

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  command -v sudo >/dev/null || {
    echo "install_deps.sh: missing packages: ${missing[*]}; run as root or install sudo" >&2
    exit 1
  }
  as_root=(sudo)
fi
echo "install_deps.sh: installing ${missing[*]}" >&2
"${as_root[@]}" apt-get -qq update
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
  apt-get -qq -y --no-install-recommends install "${missing[@]}" >/dev/null
