"""Public sources that a person may choose from, each with its terms. None of them is asked before that choice."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

from epf_gcs.fields.order import Kind


@dataclass(frozen=True, slots=True)
class KnownSource:
    """`terms`: what its owner asks, in a sentence; `terms_url`: where it is written in full. `usual_zoom`: a level that
    shows a field well and is not too much."""

    id: str
    kind: Kind
    name: str
    url: str
    attribution: str
    terms: str
    terms_url: str
    maximum_zoom: int
    usual_zoom: int


KNOWN_SOURCES: Final = (
    KnownSource(
        id="terrain-tiles",
        kind="heights",
        name="Terrain Tiles (AWS)",
        url="https://s3.amazonaws.com/elevation-tiles-prod/terrarium/{z}/{x}/{y}.png",
        attribution="Mapzen / Tilezen Joerd: SRTM, GMTED, NED, EU-DEM, ETOPO1 and others",
        terms="Open data. Name the sources: Mapzen, SRTM, GMTED, NED, EU-DEM, ETOPO1 and others.",
        terms_url="https://github.com/tilezen/joerd/blob/master/docs/attribution.md",
        maximum_zoom=14,
        usual_zoom=12,
    ),
    KnownSource(
        id="copernicus-glo30",
        kind="heights",
        name="Copernicus GLO-30",
        url=(
            "https://copernicus-dem-30m.s3.amazonaws.com/Copernicus_DSM_COG_10_{latitude}_00_{longitude}_00_DEM/"
            "Copernicus_DSM_COG_10_{latitude}_00_{longitude}_00_DEM.tif"
        ),
        attribution=(
            "© DLR e.V. 2010-2014 and © Airbus Defence and Space GmbH 2014-2018, provided under COPERNICUS by the "
            "European Union and ESA"
        ),
        terms="Free of charge for every use. Name DLR, Airbus, the European Union and ESA.",
        terms_url="https://dataspace.copernicus.eu/explore-data/data-collections/copernicus-contributing-missions",
        maximum_zoom=12,
        usual_zoom=12,
    ),
    KnownSource(
        id="pnoa",
        kind="imagery",
        name="PNOA (IGN, España)",
        url=(
            "https://www.ign.es/wmts/pnoa-ma?service=WMTS&request=GetTile&version=1.0.0&layer=OI.OrthoimageCoverage"
            "&style=default&format=image/jpeg&tilematrixset=GoogleMapsCompatible"
            "&tilematrix={z}&tilerow={y}&tilecol={x}"
        ),
        attribution="PNOA © Instituto Geográfico Nacional de España, CC BY 4.0",
        terms="Spain alone. CC BY 4.0: name the Instituto Geográfico Nacional.",
        terms_url="https://www.ign.es/web/ign/portal/politica-datos",
        maximum_zoom=19,
        usual_zoom=16,
    ),
    KnownSource(
        id="sentinel2",
        kind="imagery",
        name="Sentinel-2 cloudless (EOX)",
        url="https://tiles.maps.eox.at/wmts/1.0.0/s2cloudless-2020_3857/default/g/{z}/{y}/{x}.jpg",
        attribution="Sentinel-2 cloudless by EOX IT Services GmbH (contains modified Copernicus Sentinel data 2020)",
        terms="The whole world, 10 m a pixel. CC BY-NC-SA 4.0: not for commercial use; name EOX and Copernicus.",
        terms_url="https://s2maps.eu",
        maximum_zoom=14,
        usual_zoom=14,
    ),
    KnownSource(
        id="usgs",
        kind="imagery",
        name="USGS Imagery",
        url="https://basemap.nationalmap.gov/arcgis/rest/services/USGSImageryOnly/MapServer/tile/{z}/{y}/{x}",
        attribution="USGS The National Map",
        terms="The United States alone. Public domain; name the USGS.",
        terms_url="https://www.usgs.gov/information-policies-and-instructions/copyrights-and-credits",
        maximum_zoom=16,
        usual_zoom=16,
    ),
)
