"""`python -m epf_gcs.web.invite`: a one-time key for a station, straight into its store, printed with a QR code.

Whoever may write the data folder owns the station: it needs no other key, and no running station.
"""

from __future__ import annotations

import argparse
import contextlib
import sys
import time
from pathlib import Path
from typing import Final

import segno

from epf_gcs.access.addresses import addresses, with_key
from epf_gcs.access.caller import is_in_container
from epf_gcs.access.invitations import new_invitation
from epf_gcs.access.moment import Moment
from epf_gcs.access.roles import Role
from epf_gcs.access.store import AccessStore, Person
from epf_gcs.data_folder.upgrade import bring_up_to_date
from epf_gcs.data_folder.version import FormatError
from epf_gcs.errors import GatewayError
from epf_gcs.system.private_files import write_private_files
from epf_gcs.web.serving.settings import Settings

_MINUTES: Final = 60.0
_MOST_MINUTES: Final = 7 * 24 * 60.0


def main() -> None:
    """Make the key and print it."""
    write_private_files()
    options = _options()
    given = {name: getattr(options, name) for name in ("host", "port", "data_dir")}
    try:
        settings = Settings(**{name: value for name, value in given.items() if value is not None})
    except ValueError as error:
        sys.exit(f"epf-gcs invite: {error}")
    try:
        bring_up_to_date(settings.data_dir, lambda said: print(said, file=sys.stderr))
        store = AccessStore(settings.data_dir)
        with contextlib.closing(store):
            if options.first and _has_owner(store):
                return
            role = Role[options.role] if options.role else _first_role(store, settings)
            key, invitation = new_invitation(store, role, options.minutes, Moment.now())
    except GatewayError as error:
        sys.exit(f"No key could be made in {settings.data_dir}: {error.detail}")
    except FormatError as error:
        sys.exit(str(error))
    until = time.strftime("%H:%M", time.localtime(invitation.until_s))
    print(f"One-time key for one {role.name}, until {until}:  {key}")
    reached = addresses(settings.host, settings.port, secure=options.tls, reached_at=settings.reached_at)
    if not reached:
        print("The station listens on this computer alone: start it with --lan to let others in.", flush=True)
        return
    print("Open it there as one of these, or scan the first:")
    for address in reached:
        print(f"  {with_key(address, key, None)}")
    if is_in_container() and settings.reached_at is None:
        print(
            "This is a container: put its host's address and the published port in their place, or give them once, as "
            "GCS_REACHED_AT=http://192.168.1.20:8000, and the code has them."
        )
    _print_qr(with_key(reached[0], key, None))
    sys.stdout.flush()


def _options() -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="epf-gcs invite", description=__doc__)
    parser.add_argument("--role", choices=[role.name for role in Role])
    parser.add_argument("--minutes", type=_minutes, default=_MINUTES)
    parser.add_argument("--first", action="store_true")
    parser.add_argument("--data-dir", type=Path)
    parser.add_argument("--host")
    parser.add_argument("--port", type=int)
    parser.add_argument("--tls", action="store_true")
    return parser.parse_args()


def _minutes(text: str) -> float:
    minutes = float(text)
    if not 1 <= minutes <= _MOST_MINUTES:
        raise argparse.ArgumentTypeError(f"1 to {_MOST_MINUTES:.0f} minutes")
    return minutes


def _first_role(store: AccessStore, settings: Settings) -> Role:
    """Where not even this computer is trusted, the first one in has to be an owner, or there would never be one."""
    return Role.operator if _has_owner(store) or settings.policy.trusts_this_computer else Role.owner


def _has_owner(store: AccessStore) -> bool:
    return any(person.role == Role.owner and person.state == "in" for person in store.all(Person))


def _print_qr(text: str) -> None:
    if (sys.stdout.encoding or "").lower().replace("-", "") == "utf8":
        segno.make(text, error="l", micro=False).terminal(out=sys.stdout, compact=True)


if __name__ == "__main__":
    main()
