import { distance_m, type Position } from "../../lib/geodesy";
import type { AirfieldAt, Cell, Country, NavaidAt, Town, WorldLevel } from "./cell";

/** A ring of ground around a place, and from which level its names come. */
export interface NamedZone {
  readonly level: WorldLevel;
  readonly from_m: number;
  readonly to_m: number;
}

/** What has a name on the map, and its rank among the names. */
export type NamedThing = Position & { readonly key: string; readonly rank: number } & (
    | { readonly kind: "town"; readonly name: string; readonly size: number }
    | { readonly kind: "country"; readonly code: string }
    | { readonly kind: "airfield"; readonly airfield: AirfieldAt }
    | { readonly kind: "navaid"; readonly navaid: NavaidAt }
  );

/** Ranks in the measure of a town's size: eight times the binary logarithm of the people. */
const AIRFIELD_RANK = [52, 62, 84, 112, 150] as const;
/** Closer to the ground airfields are more than towns to those who fly. */
const CLOSE_M = 40_000;
const CLOSE_RANK = 42;
const NAVAID_RANK = 70;
const NAVAID_M = 90_000;
const COUNTRY_RANK = 60;
/** Countries are named from at least this far. */
const COUNTRY_M = 900_000;
/** So much rank is lost with each doubling of the distance. */
const FAR_RANK = 6;
const NEAR_M = 20_000;

/** The things of a cell that lie in a zone around a place, seen from so far away. */
export function thingsIn(cell: Cell, zone: NamedZone, centre: Position, sight_m: number): NamedThing[] {
  const close = sight_m < CLOSE_M ? CLOSE_RANK : 0;
  const seen: NamedThing[] = [
    ...cell.towns.map(townThing),
    ...cell.airfields.map((airfield) => airfieldThing(airfield, close)),
    ...(sight_m < NAVAID_M ? cell.navaids.map(navaidThing) : []),
    ...(sight_m > COUNTRY_M ? cell.countries.map(countryThing) : []),
  ];
  return seen.flatMap((thing) => {
    const away_m = distance_m(centre, thing);
    if (away_m < zone.from_m || away_m >= zone.to_m) {
      return [];
    }
    const doubled = Math.log2(Math.max(away_m, sight_m) / Math.max(NEAR_M, sight_m));
    return [{ ...thing, rank: thing.rank - FAR_RANK * Math.max(0, doubled) }];
  });
}

function townThing({ name, size, longitude_deg, latitude_deg }: Town): NamedThing {
  // Names repeat; two towns of one name are not nearer to each other than this.
  const key = `t${name}${longitude_deg.toFixed(1)},${latitude_deg.toFixed(1)}`;
  return { key, kind: "town", name, size, longitude_deg, latitude_deg, rank: size };
}

function airfieldThing(airfield: AirfieldAt, close: number): NamedThing {
  const rank = (AIRFIELD_RANK[airfield.weight] ?? 0) + close;
  return { ...placeOf(airfield), key: `a${airfield.code}`, kind: "airfield", airfield, rank };
}

function navaidThing(navaid: NavaidAt): NamedThing {
  const key = `n${navaid.code}${navaid.type}${navaid.longitude_deg.toFixed(2)}`;
  return { ...placeOf(navaid), key, kind: "navaid", navaid, rank: NAVAID_RANK };
}

function countryThing({ code, area_km2, longitude_deg, latitude_deg }: Country): NamedThing {
  const rank = COUNTRY_RANK + 8 * Math.log2(area_km2);
  return { key: `c${code}`, kind: "country", code, longitude_deg, latitude_deg, rank };
}

function placeOf({ longitude_deg, latitude_deg }: Position): Position {
  return { longitude_deg, latitude_deg };
}

/** The things of the highest rank, each key once. */
export function highest(things: Iterable<NamedThing>, most: number): NamedThing[] {
  const byKey = new Map<string, NamedThing>();
  for (const thing of things) {
    const known = byKey.get(thing.key);
    if (known === undefined || known.rank < thing.rank) {
      byKey.set(thing.key, thing);
    }
  }
  return [...byKey.values()].sort((one, other) => other.rank - one.rank).slice(0, most);
}

export interface NearAirfield {
  readonly airfield: AirfieldAt;
  readonly away_m: number;
}

/** The airfields for aircraft with wheels that are nearest to a place. */
export function nearestOf(cells: readonly Cell[], place: Position, most: number): NearAirfield[] {
  return cells
    .flatMap(({ airfields }) => airfields)
    .filter(({ weight }) => weight >= 2)
    .map((airfield) => ({ airfield, away_m: distance_m(place, airfield) }))
    .sort((one, other) => one.away_m - other.away_m)
    .slice(0, most);
}
