import type { Position } from "./geodesy";
import { DEGREES_PER_RADIAN } from "./units";

/** The notations in which a place is written. */
export const NOTATIONS = ["decimal", "dms", "utm"] as const;
export type CoordinateNotation = (typeof NOTATIONS)[number];

/** A place in a zone of the Universal Transverse Mercator projection (WGS 84). */
export interface Utm {
  /** 1..60, from the date line east. */
  readonly zone: number;
  readonly isNorth: boolean;
  readonly easting_m: number;
  readonly northing_m: number;
}

/** The projection is used between these latitudes. */
const UTM_SOUTH_DEG = -80;
const UTM_NORTH_DEG = 84;
const BANDS = "CDEFGHJKLMNPQRSTUVWX";
const SCALE = 0.9996;
const FALSE_EASTING_M = 500_000;
const FALSE_NORTHING_M = 10_000_000;

const EQUATOR_M = 6_378_137;
const FLATTENING = 1 / 298.257223563;
const ECCENTRICITY = Math.sqrt(FLATTENING * (2 - FLATTENING));
const N = FLATTENING / (2 - FLATTENING);
const RECTIFYING_M = (EQUATOR_M / (1 + N)) * (1 + N ** 2 / 4 + N ** 4 / 64);
/** Krüger's series to the fourth order: under a micrometre within a zone. */
const ALPHA = [
  N / 2 - (2 / 3) * N ** 2 + (5 / 16) * N ** 3 + (41 / 180) * N ** 4,
  (13 / 48) * N ** 2 - (3 / 5) * N ** 3 + (557 / 1440) * N ** 4,
  (61 / 240) * N ** 3 - (103 / 140) * N ** 4,
  (49561 / 161280) * N ** 4,
] as const;
const BETA = [
  N / 2 - (2 / 3) * N ** 2 + (37 / 96) * N ** 3 - (1 / 360) * N ** 4,
  (1 / 48) * N ** 2 + (1 / 15) * N ** 3 - (437 / 1440) * N ** 4,
  (17 / 480) * N ** 3 - (37 / 840) * N ** 4,
  (4397 / 161280) * N ** 4,
] as const;
const PASSES = 6;

/** The place in its zone; null beyond the latitudes of the projection. */
export function utmOf({ latitude_deg, longitude_deg }: Position): Utm | null {
  if (!(latitude_deg >= UTM_SOUTH_DEG && latitude_deg <= UTM_NORTH_DEG)) {
    return null;
  }
  const zone = zoneOf(latitude_deg, longitude_deg);
  const latitude = latitude_deg / DEGREES_PER_RADIAN;
  const away = (((((longitude_deg - middleOf(zone) + 180) % 360) + 360) % 360) - 180) / DEGREES_PER_RADIAN;
  const sine = Math.sin(latitude);
  const conformal = Math.sinh(Math.atanh(sine) - ECCENTRICITY * Math.atanh(ECCENTRICITY * sine));
  const xi = Math.atan2(conformal, Math.cos(away));
  const eta = Math.asinh(Math.sin(away) / Math.hypot(conformal, Math.cos(away)));
  const [north, east] = series(xi, eta, ALPHA, 1);
  return {
    zone,
    isNorth: latitude_deg >= 0,
    easting_m: FALSE_EASTING_M + SCALE * RECTIFYING_M * east,
    northing_m: (latitude_deg >= 0 ? 0 : FALSE_NORTHING_M) + SCALE * RECTIFYING_M * north,
  };
}

/** The place of a zone's coordinates. */
export function placeOfUtm({ zone, isNorth, easting_m, northing_m }: Utm): Position {
  const [xi, eta] = series(
    (northing_m - (isNorth ? 0 : FALSE_NORTHING_M)) / (SCALE * RECTIFYING_M),
    (easting_m - FALSE_EASTING_M) / (SCALE * RECTIFYING_M),
    BETA,
    -1,
  );
  const conformal = Math.sin(xi) / Math.hypot(Math.sinh(eta), Math.cos(xi));
  // Newton's way back from the conformal latitude.
  let tangent = conformal;
  for (let pass = 0; pass < PASSES; pass += 1) {
    const sine = tangent / Math.hypot(1, tangent);
    const bend = Math.sinh(ECCENTRICITY * Math.atanh(ECCENTRICITY * sine));
    const reached = tangent * Math.hypot(1, bend) - bend * Math.hypot(1, tangent);
    const flat = 1 - ECCENTRICITY ** 2;
    tangent +=
      ((conformal - reached) / Math.hypot(1, reached)) *
      ((1 + flat * tangent ** 2) / (flat * Math.hypot(1, tangent)));
  }
  const longitude_deg = middleOf(zone) + Math.atan2(Math.sinh(eta), Math.cos(xi)) * DEGREES_PER_RADIAN;
  return {
    latitude_deg: Math.atan(tangent) * DEGREES_PER_RADIAN,
    longitude_deg: ((((longitude_deg + 180) % 360) + 360) % 360) - 180,
  };
}

function series(xi: number, eta: number, terms: readonly number[], sign: 1 | -1): readonly [number, number] {
  let [north, east] = [xi, eta];
  for (const [index, term] of terms.entries()) {
    const twice = 2 * (index + 1);
    north += sign * term * Math.sin(twice * xi) * Math.cosh(twice * eta);
    east += sign * term * Math.cos(twice * xi) * Math.sinh(twice * eta);
  }
  return [north, east];
}

function middleOf(zone: number): number {
  return 6 * zone - 183;
}

/** With the exceptions of south-west Norway and Svalbard. */
function zoneOf(latitude_deg: number, longitude_deg: number): number {
  const east_deg = (((longitude_deg + 180) % 360) + 360) % 360;
  const longitude = east_deg - 180;
  if (latitude_deg >= 56 && latitude_deg < 64 && longitude >= 3 && longitude < 12) {
    return 32;
  }
  if (latitude_deg >= 72 && longitude >= 0 && longitude < 42) {
    return longitude < 9 ? 31 : longitude < 21 ? 33 : longitude < 33 ? 35 : 37;
  }
  return Math.floor(east_deg / 6) + 1;
}

/** A place as people write it; decimal degrees where the notation does not reach. */
export function formatPlace(place: Position, notation: CoordinateNotation): string {
  const utm = notation === "utm" ? utmOf(place) : null;
  if (utm !== null) {
    const band =
      BANDS[Math.min(BANDS.length - 1, Math.floor((place.latitude_deg - UTM_SOUTH_DEG) / 8))] ?? "";
    return `${utm.zone}${band} ${utm.easting_m.toFixed(1)} ${utm.northing_m.toFixed(1)}`;
  }
  return notation === "dms"
    ? `${sexagesimal(place.latitude_deg, "N", "S")} ${sexagesimal(place.longitude_deg, "E", "W")}`
    : `${place.latitude_deg.toFixed(6)} ${place.longitude_deg.toFixed(6)}`;
}

/** Hundredths of a second are 0.3 m. */
function sexagesimal(angle_deg: number, positive: string, negative: string): string {
  const hundredths = Math.round(Math.abs(angle_deg) * 360_000);
  const seconds = ((hundredths % 6000) / 100).toFixed(2).padStart(5, "0");
  const minutes = String(Math.floor(hundredths / 6000) % 60).padStart(2, "0");
  return `${Math.floor(hundredths / 360_000)}°${minutes}′${seconds}″${angle_deg < 0 ? negative : positive}`;
}

/**
 * The place that somebody typed, in any of the three notations: decimal degrees with signs or letters, degrees with
 * minutes and seconds, UTM with zone and band. Spanish letters too (O for the west). Null if it is none.
 */
export function parsePlace(text: string): Position | null {
  const plain = text.trim().toUpperCase();
  const found = parseUtm(plain) ?? parseDegrees(plain);
  const isPlace =
    found !== null && Math.abs(found.latitude_deg) <= 90 && Math.abs(found.longitude_deg) <= 180;
  return isPlace ? found : null;
}

const UTM =
  /^(?<zone>\d{1,2})\s*(?<band>[C-HJ-NP-X])\s+(?<east>\d+(?:[.,]\d+)?)\s*M?\s*E?[\s;]+(?<north>\d+(?:[.,]\d+)?)\s*M?\s*N?$/;

function parseUtm(text: string): Position | null {
  const groups = UTM.exec(text)?.groups;
  if (groups === undefined) {
    return null;
  }
  const zone = Number(groups["zone"]);
  const easting_m = numberOf(groups["east"] ?? "");
  const northing_m = numberOf(groups["north"] ?? "");
  const isUtm =
    zone >= 1 &&
    zone <= 60 &&
    easting_m >= 100_000 &&
    easting_m < 1_000_000 &&
    northing_m <= FALSE_NORTHING_M;
  return isUtm ? placeOfUtm({ zone, isNorth: (groups["band"] ?? "") >= "N", easting_m, northing_m }) : null;
}

/** One angle: degrees, and maybe minutes and seconds, each with or without its mark. */
const ANGLE =
  /^(?<first>[NSEWO])?\s*(?<sign>[-+])?(?<degrees>\d+(?:\.\d+)?)\s*°?\s*(?:(?<minutes>\d+(?:\.\d+)?)\s*['′’]?\s*)?(?:(?<seconds>\d+(?:\.\d+)?)\s*(?:["″”]|''|′′)?\s*)?(?<last>[NSEWO])?$/;

function parseDegrees(text: string): Position | null {
  // A comma between the two, or as a decimal sign where something else stands between them.
  const halves = splitOf(text);
  const [first, second] = (halves ?? []).map((half) => angleOf(half.replace(/(?<=\d),(?=\d)/, ".")));
  if (first === undefined || second === undefined || first === null || second === null) {
    return null;
  }
  const isTurned = first.axis === "longitude" || second.axis === "latitude";
  if (first.axis !== null && first.axis === second.axis) {
    return null;
  }
  const [latitude, longitude] = isTurned ? [second, first] : [first, second];
  return { latitude_deg: latitude.angle_deg, longitude_deg: longitude.angle_deg };
}

/** At a letter of a direction, a semicolon, a comma with a space or the only comma, or the only space. */
function splitOf(text: string): readonly string[] | null {
  const forms = [
    /^([NSEWO].*?\d[^\s,;]*)[\s,;]+([NSEWO].*)$/,
    /^(.*\d.*?[NSEWO])[\s,;]*([-+\d].*)$/,
    /^([^;]+);([^;]+)$/,
    /^([^,]*\d[^,]*),\s+([^,]+)$/,
    /^([-+]?[\d.]+)\s*,\s*([-+]?[\d.]+)$/,
    /^(\S+)\s+(\S+)$/,
    /^(\S+\s+\S+\s+\S+)\s+(\S+\s+\S+\s+\S+)$/,
  ];
  const halves = forms.map((form) => form.exec(text)).find((found) => found !== null);
  return halves === undefined || halves === null ? null : [halves[1] ?? "", halves[2] ?? ""];
}

function angleOf(text: string): { angle_deg: number; axis: "latitude" | "longitude" | null } | null {
  const groups = ANGLE.exec(text.trim())?.groups;
  if (groups === undefined) {
    return null;
  }
  const letter = groups["first"] ?? groups["last"] ?? null;
  const [minutes, seconds] = [Number(groups["minutes"] ?? 0), Number(groups["seconds"] ?? 0)];
  const isTwice = letter !== null && (groups["sign"] === "-" || (groups["first"] && groups["last"]));
  if (isTwice || minutes >= 60 || seconds >= 60) {
    return null;
  }
  const size_deg = Number(groups["degrees"]) + minutes / 60 + seconds / 3600;
  const isNegative = groups["sign"] === "-" || letter === "S" || letter === "W" || letter === "O";
  const axis = letter === null ? null : letter === "N" || letter === "S" ? "latitude" : "longitude";
  return { angle_deg: isNegative ? -size_deg : size_deg, axis };
}

function numberOf(text: string): number {
  return Number(text.replace(",", "."));
}
