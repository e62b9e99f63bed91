#!/usr/bin/env bash
# Builds wheels of jsbsim, as backend/requirements.lock names it, for a processor for which the registry has none: aarch64.
# Runs on a machine of that kind with docker (ENGINE=podman), in the image in which such wheels are made.
#
#     build.sh FOLDER
#
# Where the registry has them by now it makes nothing and says so.
set -euo pipefail
cd "$(dirname "$0")/../.."
mkdir -p "$1"
folder=$(cd "$1" && pwd)
machine=$(uname -m)
engine=${ENGINE:-docker}
wanted=$(grep -oE '^jsbsim==[^ ;]+' backend/requirements.lock)

if python3 -m pip download --quiet --no-deps --only-binary=:all: --python-version 3.11 \
  --platform "manylinux_2_28_$machine" --platform "manylinux2014_$machine" --dest "$(mktemp -d)" "$wanted" 2>/dev/null; then
  echo "The registry has a wheel of $wanted for $machine: nothing to build."
  exit 0
fi
# The sources are those that the lock names by their checksum.
sources=$(mktemp -d)
awk '/^jsbsim==/ { on = 1 } on { print } on && !/\\$/ { exit }' backend/requirements.lock |
  sed '1s/ *;[^\\]*//' >"$sources/requirements.txt"
"$engine" run --rm --volume "$sources:/sources" --volume "$folder:/wheels" "quay.io/pypa/manylinux_2_28_$machine" bash -euc '
  for python in cp311 cp312 cp313 cp314; do
    pip=/opt/python/$python-$python/bin/pip
    "$pip" wheel --quiet --no-deps --require-hashes --no-binary :all: --wheel-dir /tmp/built -r /sources/requirements.txt
  done
  for wheel in /tmp/built/jsbsim-*.whl; do auditwheel repair --wheel-dir /wheels "$wheel"; done'
ls "$folder"
