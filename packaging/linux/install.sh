#!/bin/sh
# Installs the station as a service on a Linux computer with systemd, for example a Raspberry Pi. Read it first:
#
#   sudo sh install.sh epf_gcs-....whl [EXTRAS]
#
# What it makes: the program in /opt/epf-gcs, a user epf-gcs, its data in /var/lib/epf-gcs, the service epf-gcs, a rule
# for serial adapters, and a command epf-gcs for all users. Run again with a newer wheel it upgrades; the data stay, and
# a version that does not start is taken back. EXTRAS: what is installed besides, `flights,maps` unless said otherwise;
# `sim` is the flight simulator, `none` nothing.
# `sh install.sh --remove` takes everything away but the data, their user and /etc/epf-gcs.conf.
set -eu

here=$(cd "$(dirname "$0")" && pwd)
program=/opt/epf-gcs
data=/var/lib/epf-gcs
unit=/etc/systemd/system/epf-gcs.service
first_key=/etc/systemd/system/epf-gcs-first-key.service
rules=/etc/udev/rules.d/70-epf-gcs.rules

fail() { echo "install.sh: $1" >&2; exit 1; }

[ "$(id -u)" = 0 ] || fail "this changes the system: run it with sudo."

if [ "${1:-}" = --remove ]; then
  systemctl disable --now epf-gcs epf-gcs-first-key 2>/dev/null || true
  rm -rf "$program" "$program.new" "$program.old" "$unit" "$first_key" "$rules" /usr/local/bin/epf-gcs
  systemctl daemon-reload
  udevadm control --reload || true
  echo "The station is gone; its data are still in $data, which the user epf-gcs owns."
  exit 0
fi

wheel=${1:-}
extras=${2:-flights,maps}
[ -f "$wheel" ] || fail "name the wheel: sudo sh install.sh epf_gcs-....whl"
command -v systemctl >/dev/null || fail "systemd is not here: install the wheel with pipx and start epf-gcs yourself."
python3 -c 'import sys; sys.exit(sys.version_info < (3, 11))' 2>/dev/null || fail "Python 3.11 or newer is needed."
python3 -c 'import venv, ensurepip' 2>/dev/null || fail "Python's venv module is missing: apt install python3-venv"

getent passwd epf-gcs >/dev/null || useradd --system --home-dir "$data" --shell /usr/sbin/nologin epf-gcs

# Beside the old one and then in its place, so that a failed download leaves the old one running. An environment keeps
# its own path in its scripts, so the folder is made where it will be.
new="$program.new"
old="$program.old"
rm -rf "$new"
trap 'rm -rf "$new"' EXIT
mkdir "$new"
python3 -m venv "$new"
[ "$extras" = none ] || extras="[$extras]"
"$new/bin/pip" install --quiet --disable-pip-version-check "$wheel${extras#none}"
"$new/bin/epf-gcs" version >/dev/null || fail "the new version does not start; nothing was changed."
install -m 644 "$here/README.md" "$new/README.md"
systemctl stop epf-gcs 2>/dev/null || true
rm -rf "$old"
[ ! -d "$program" ] || mv "$program" "$old"
mv "$new" "$program"
# The scripts name the folder that they were made in. The interpreter is a link to the system's: it stays one.
for script in "$program"/bin/*; do
  [ -L "$script" ] || [ "$(head -c 2 "$script")" != "#!" ] || sed -i "1s|$new/|$program/|" "$script"
done

install -m 644 "$here/epf-gcs.service" "$unit"
install -m 644 "$here/epf-gcs-first-key.service" "$first_key"
install -m 644 "$here/70-epf-gcs.rules" "$rules"
ln -sf "$program/bin/epf-gcs" /usr/local/bin/epf-gcs
[ -f /etc/epf-gcs.conf ] || install -m 644 "$here/epf-gcs.conf" /etc/epf-gcs.conf
systemctl daemon-reload
udevadm control --reload && udevadm trigger --subsystem-match=tty || true
systemctl enable --quiet epf-gcs epf-gcs-first-key
# It says by itself when it is ready; a start that fails is an answer here.
if ! systemctl restart epf-gcs; then
  systemctl stop epf-gcs || true
  [ -d "$old" ] || fail "the station does not start: journalctl -u epf-gcs tells why."
  rm -rf "$program"
  mv "$old" "$program"
  systemctl restart epf-gcs || fail "neither version starts: journalctl -u epf-gcs tells why."
  fail "the new version does not start, the one before runs again: journalctl -u epf-gcs tells why."
fi
rm -rf "$old"
systemctl restart epf-gcs-first-key || true

echo "The station runs. The first person's key is on this computer's own screen, if it has one; here with:"
echo "  sudo -u epf-gcs epf-gcs invite --role owner --data-dir $data"
