"""The words in our KML, in the languages of the page."""

from __future__ import annotations

from typing import Final, Literal, NamedTuple

Language = Literal["es", "en"]


class Words(NamedTuple):
    """The words in one language."""

    station: str
    track: str
    hil_track: str
    plan: str
    hil_plan: str
    aircraft: str
    hil_aircraft: str
    last_known: str
    examples: str
    altitude: str
    speed: str
    heading: str
    thinned: str
    events: str
    mark: str
    waypoint: str


WORDS: Final[dict[Language, Words]] = {
    "es": Words(
        station="EPF GCS",
        track="Recorrido",
        hil_track="Recorrido HIL",
        plan="Plan de vuelo",
        hil_plan="Plan de vuelo HIL",
        aircraft="Aeronave",
        hil_aircraft="Aeronave HIL",
        last_known="última posición conocida",
        examples="emulación",
        altitude="Altura",
        speed="Velocidad",
        heading="Rumbo",
        thinned="Con menos puntos: ninguna muestra queda a más de {deviation_m:.0f} m del recorrido a su hora.",
        events="Lo que pasó",
        mark="Marca",
        waypoint="Waypoint",
    ),
    "en": Words(
        station="EPF GCS",
        track="Track",
        hil_track="HIL track",
        plan="Flight plan",
        hil_plan="HIL flight plan",
        aircraft="Aircraft",
        hil_aircraft="HIL aircraft",
        last_known="last known position",
        examples="emulation",
        altitude="Altitude",
        speed="Speed",
        heading="Heading",
        thinned="With fewer points: no sample is more than {deviation_m:.0f} m from the track at its time.",
        events="What happened",
        mark="Mark",
        waypoint="Waypoint",
    ),
}
