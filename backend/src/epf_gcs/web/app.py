"""The composition root: constructs the parts, starts and stops them."""

from __future__ import annotations

import contextlib
from collections import Counter
from collections.abc import AsyncIterator
from typing import Any, Final

from fastapi import APIRouter, FastAPI

from epf_gcs import __version__
from epf_gcs.access.addresses import own_names
from epf_gcs.access.admission import Admission
from epf_gcs.access.limits import CallerLimits
from epf_gcs.clock import Clock
from epf_gcs.contract.status import Status
from epf_gcs.error_log import ErrorLog
from epf_gcs.formats.recognise import MAX_FILE_BYTES
from epf_gcs.maps.outside import Consent
from epf_gcs.product import PAGE
from epf_gcs.tls.keeper import Keeper
from epf_gcs.web import docs
from epf_gcs.web.endpoint import StreamEndpoint
from epf_gcs.web.interface.about import routes as about
from epf_gcs.web.interface.access import routes as access_routes
from epf_gcs.web.interface.alarms import routes as alarms
from epf_gcs.web.interface.backups import routes as backups
from epf_gcs.web.interface.checklist import routes as checklist
from epf_gcs.web.interface.commands import ahrs_test_routes as ahrs_test
from epf_gcs.web.interface.commands import routes as commands
from epf_gcs.web.interface.earth import routes as earth
from epf_gcs.web.interface.faults import routes as faults
from epf_gcs.web.interface.fields import routes as fields
from epf_gcs.web.interface.flights import data_routes as flight_data
from epf_gcs.web.interface.flights import export_routes as flight_exports
from epf_gcs.web.interface.flights import job_routes as jobs
from epf_gcs.web.interface.flights import mark_routes as flight_marks
from epf_gcs.web.interface.flights import plan_routes as flight_plans
from epf_gcs.web.interface.flights import report_routes as flight_reports
from epf_gcs.web.interface.flights import routes as flights
from epf_gcs.web.interface.inspector import routes as inspector
from epf_gcs.web.interface.links import routes as links
from epf_gcs.web.interface.maps import online_routes as online_maps
from epf_gcs.web.interface.maps import routes as maps
from epf_gcs.web.interface.missions import file_routes as mission_files
from epf_gcs.web.interface.missions import rehearsal_routes as mission_rehearsals
from epf_gcs.web.interface.missions import routes as missions
from epf_gcs.web.interface.parameters import routes as parameters
from epf_gcs.web.interface.recordings import routes as recordings
from epf_gcs.web.interface.setup import routes as setup
from epf_gcs.web.interface.state import routes as state
from epf_gcs.web.interface.state.probes import disk_of, probe_router
from epf_gcs.web.interface.surroundings import routes as surroundings
from epf_gcs.web.interface.tls import routes as certificate_routes
from epf_gcs.web.interface.track import routes as track
from epf_gcs.web.serving.access_table import Gate
from epf_gcs.web.serving.body_limits import BodyLimits
from epf_gcs.web.serving.guard import Entrance, Guard
from epf_gcs.web.serving.origins import Access
from epf_gcs.web.serving.page import install_page
from epf_gcs.web.serving.problems import install_error_handlers
from epf_gcs.web.serving.settings import Settings
from epf_gcs.web.serving.visitors import Visitors
from epf_gcs.web.state.figures import WebFigures
from epf_gcs.web.state.whole import WholeStatus
from epf_gcs.web.station import Station
from epf_gcs.web.vehicle.mirror import VehicleMirror

_PREFIX: Final = "/api/v1"


def _interface() -> APIRouter:
    """Every route that is the same in each application."""
    together = APIRouter()
    for part in (
        state,
        links,
        commands,
        faults,
        ahrs_test,
        parameters,
        mission_files,
        mission_rehearsals,
        missions,
        earth,
        track,
        maps,
        online_maps,
        fields,
        alarms,
        checklist,
        surroundings,
        recordings,
        flights,
        flight_reports,
        flight_data,
        flight_exports,
        flight_marks,
        flight_plans,
        jobs,
        backups,
        about,
        setup,
        inspector,
        certificate_routes,
        access_routes,
    ):
        together.include_router(part.router, prefix=_PREFIX)
    together.include_router(docs.router)
    return together


# Working out what its routes take and give costs a quarter of a second: once, however many applications there are.
_INTERFACE: Final = _interface()


def create_app(settings: Settings, visitors: Visitors | None = None, certificates: Keeper | None = None) -> FastAPI:
    """The web process as an ASGI application; the stream needs `web.server`, which hands it the transports.

    `visitors` are the connections of the server around it, and how all is shared; `certificates` are what it shows
    under TLS.
    """
    policy = settings.policy
    visitors = Visitors() if visitors is None else visitors
    shares = visitors.shares
    names = own_names() if policy.is_reached_by_others else []
    if certificates is not None:
        # A page of another name, resolved to this machine, gets no further than its browser's warning.
        names += certificates.in_use.names
    access = Access((*settings.names, *names), settings.allowed_origins, secure=certificates is not None)
    errors = ErrorLog()
    if certificates is not None:
        certificates.on_fault = errors.report
    answers: Counter[int] = Counter()
    clock = Clock()
    admission = Admission(policy, settings.data_dir, errors.report, clock, hosts=visitors.hosts, shares=shares)
    admission.listen_at(settings.port)
    limits = CallerLimits(clock.steady_s, shares)

    @contextlib.asynccontextmanager
    async def lifespan(app: FastAPI) -> AsyncIterator[dict[str, Any]]:
        station = Station(
            settings.data_dir, errors, clock, shares=shares, control_by_silence=settings.control_by_silence
        )
        for name, part in station.parts.items():
            setattr(app.state, name, part)
        station.maps.online.consent = Consent(settings.local_maps)
        async with admission.running(), station.running():
            station.follow(admission)
            endpoint = StreamEndpoint(station.stream_parts, access)
            yield {"socket_endpoint": endpoint, "admission": admission, "limits": limits}

    app = FastAPI(
        title="EPF GCS gateway",
        version=__version__,
        lifespan=lifespan,
        openapi_url=docs.OPENAPI_PATH,
        docs_url=None,
        redoc_url=None,
        routes=_INTERFACE.routes,
    )
    app.state.access = access
    app.state.certificates = certificates
    app.openapi = lambda: docs.describe(app)  # type: ignore[method-assign]
    install_error_handlers(app, errors)
    app.include_router(_probes(app, settings, visitors, answers))
    install_page(app, settings.page_dir or PAGE.folder)
    app.state.admission = admission
    app.state.limits = limits
    app.add_middleware(
        Guard,
        entrance=Entrance(access, admission, Gate(app), limits),
        bodies=BodyLimits(
            settings.max_body_bytes,
            longer={_PREFIX + path: MAX_FILE_BYTES for path in (mission_files.IMPORT_PATH, surroundings.IMPORT_PATH)},
            streamed=frozenset({_PREFIX + maps.IMPORTS_PATH, _PREFIX + flights.UPLOAD_PATH}),
        ),
        errors=errors,
        answers=answers,
    )
    return app


def _probes(app: FastAPI, settings: Settings, visitors: Visitors, answers: Counter[int]) -> APIRouter:
    """The routes /health and /metrics."""

    def flight_status() -> Status | None:
        mirror: VehicleMirror = app.state.mirror
        whole: WholeStatus = app.state.status
        return whole.build() if mirror.is_here else None

    def figures() -> WebFigures:
        return WebFigures(answers, len(visitors), visitors.sockets, visitors.refused)

    return probe_router(flight_status, figures, lambda: disk_of(settings.data_dir))
