"""Routes of the certificates: what is there, and the authority's certificate for phones that shall trust it."""

from __future__ import annotations

from typing import Annotated, Literal

from fastapi import APIRouter, Depends, Request
from fastapi.responses import Response

from epf_gcs.contract.shapes import FILE, Output, ParamValue
from epf_gcs.errors import ErrorCode, NotFoundError
from epf_gcs.tls.certificates import fingerprint_of
from epf_gcs.tls.keeper import Keeper
from epf_gcs.web.serving.problems import reading_problems

MEDIA_TYPE = "application/x-x509-ca-cert"

router = APIRouter(prefix="/access", tags=["access"])


class CertificateFault(Output):
    """What is wrong with the certificate, or soon will be."""

    code: ErrorCode
    detail: str
    params: dict[str, ParamValue]


class CertificateAuthority(Output):
    """The station's own authority. `fingerprint` is its SHA-256, to compare on the phone that shall trust it."""

    name: str
    fingerprint: str
    until_s: float


class StationCertificate(Output):
    """`made` by the station or `brought` by its user. Times are Unix seconds, `fingerprint` is SHA-256."""

    kind: Literal["made", "brought"]
    names: list[str]
    addresses: list[str]
    fingerprint: str
    since_s: float
    until_s: float


class Certificates(Output):
    """`certificate` is null while the station speaks plain HTTP; `authority` also while the certificate was brought."""

    certificate: StationCertificate | None
    authority: CertificateAuthority | None
    fault: CertificateFault | None


async def _keeper(request: Request) -> Keeper | None:
    found: Keeper | None = request.app.state.certificates
    return found


KeeperDep = Annotated[Keeper | None, Depends(_keeper)]
"""The certificate in use; None without TLS."""


@router.get("/certificates", responses=reading_problems())
async def get_certificates(keeper: KeeperDep) -> Certificates:
    """The certificate that this station shows to browsers, and what is wrong with it."""
    if keeper is None:
        return Certificates(certificate=None, authority=None, fault=None)
    used, fault = keeper.in_use, keeper.fault
    certificate, authority = used.found.certificate, used.found.authority
    return Certificates(
        certificate=StationCertificate(
            kind=used.kind,
            names=used.names,
            addresses=used.addresses,
            fingerprint=used.fingerprint,
            since_s=certificate.not_valid_before_utc.timestamp(),
            until_s=certificate.not_valid_after_utc.timestamp(),
        ),
        authority=None
        if authority is None
        else CertificateAuthority(
            name=authority.subject.rfc4514_string().removeprefix("CN="),
            fingerprint=fingerprint_of(authority),
            until_s=authority.not_valid_after_utc.timestamp(),
        ),
        fault=None if fault is None else CertificateFault(code=fault.code, detail=fault.detail, params=fault.params),
    )


@router.get(
    "/authority",
    responses={
        200: {"content": {MEDIA_TYPE: FILE}},
        **reading_problems(404),
    },
    response_class=Response,
)
async def get_authority(keeper: KeeperDep) -> Response:
    """The authority's certificate (DER), for a phone or a browser that shall trust this station."""
    der = None if keeper is None else keeper.in_use.authority_der()
    if der is None:
        raise NotFoundError(
            "tls_no_authority",
            "This station has no authority of its own: it speaks plain HTTP, or its certificate was brought.",
        )
    headers = {"Content-Disposition": 'attachment; filename="epf-gcs.crt"'}
    return Response(der, media_type=MEDIA_TYPE, headers=headers)
