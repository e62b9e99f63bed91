"""All events of the stream, by name, with the shape of their data; the page's checks are generated from this."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Final

from epf_gcs.contract import events
from epf_gcs.contract.events import SubjectEvent
from epf_gcs.web.interface.fields.schemas import PreparedField
from epf_gcs.web.interface.flights.schemas import Job
from epf_gcs.web.interface.maps.schemas import MapImport
from epf_gcs.web.interface.track.schemas import TrackState

_SUBJECTS: Final[Mapping[SubjectEvent, type[Any]]] = {
    "job": Job,
    "map_field": PreparedField,
    "map_import": MapImport,
    "track": TrackState,
}
EVENTS: Final[Mapping[str, type[Any]]] = {**events.EVENTS, **{str(name): kind for name, kind in _SUBJECTS.items()}}
