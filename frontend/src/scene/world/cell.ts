import type { Position } from "../../lib/geodesy";

/** The levels of detail that ship: the whole world, regions, and all that is known. */
export type WorldLevel = 0 | 1 | 2;

/** One square of a level's grid: columns from the date line east, rows from the south pole. */
export interface CellPlace {
  readonly level: WorldLevel;
  readonly column: number;
  readonly row: number;
  readonly size_deg: number;
}

export interface Town extends Position {
  readonly name: string;
  /** Eight times the binary logarithm of the people. */
  readonly size: number;
}

export interface Country extends Position {
  /** ISO 3166. */
  readonly code: string;
  readonly area_km2: number;
}

export interface RunwayOf {
  readonly ends: readonly [string, string];
  readonly length_ft: number | null;
  readonly width_ft: number | null;
  /** `asphalt`, `grass` …; empty: not known. */
  readonly surface: string;
  readonly isLit: boolean;
  /** Where both ends are; null: the source does not say. */
  readonly places: readonly [Position, Position] | null;
}

export interface FrequencyOf {
  readonly type: string;
  readonly description: string;
  readonly mhz: number;
}

export interface AirfieldAt extends Position {
  readonly code: string;
  readonly name: string;
  readonly elevation_ft: number | null;
  /** Empty, or S for seaplanes, H for helicopters, B for balloons. */
  readonly kind: string;
  /** 4: large, 3: medium, 2: small, less: no airfield for aircraft with wheels. */
  readonly weight: number;
  /** Null on the coarser levels, which do not hold them. */
  readonly runways: readonly RunwayOf[] | null;
  readonly frequencies: readonly FrequencyOf[] | null;
}

export interface NavaidAt extends Position {
  readonly code: string;
  readonly name: string;
  readonly type: string;
  readonly frequency_khz: number | null;
  readonly elevation_ft: number | null;
  readonly dmeChannel: string;
}

/** Closed rings or lines: x and y of all points in turn, and where each shape begins; one more at the end. */
export interface Shapes {
  readonly points: Int32Array;
  readonly starts: Int32Array;
}

export interface Cell {
  readonly place: CellPlace;
  /** Filled by the even-odd rule. */
  readonly land: Shapes;
  readonly borders: Shapes;
  readonly towns: readonly Town[];
  readonly countries: readonly Country[];
  readonly airfields: readonly AirfieldAt[];
  readonly navaids: readonly NavaidAt[];
}

/** Shapes are in these parts of the cell's side, things in those. */
export const SHAPE_UNITS = 32_768;
const PLACE_UNITS = 65_535;
const RUNWAY_UNITS = 1e5;

type RunwayRow = [string, string, number | null, number | null, string, number, number[]];
interface Tables {
  readonly places?: [string[]];
  readonly countries?: [string[], number[]];
  readonly airfields?: [
    string[],
    string[],
    (number | null)[],
    string[],
    number[],
    RunwayRow[][]?,
    [string, string, number][][]?,
  ];
  readonly navaids?: [string[], string[], string[], (number | null)[], (number | null)[], (string | 0)[]];
}

/** A cell from its unpacked file, as `backend/tools/world_map/cells.py` writes it. Throws on a file that is cut. */
export function decodeCell(bytes: Uint8Array, place: CellPlace): Cell {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const text_end = 4 + view.getUint32(0, true);
  const tables = JSON.parse(new TextDecoder().decode(bytes.subarray(4, text_end))) as Tables;
  let at = text_end;
  const positions = (count: number): Position[] => {
    const found = Array.from({ length: count }, (_, index) => ({
      longitude_deg: westOf(place) + (view.getUint16(at + 2 * index, true) / PLACE_UNITS) * place.size_deg,
      latitude_deg:
        southOf(place) + (view.getUint16(at + 2 * (count + index), true) / PLACE_UNITS) * place.size_deg,
    }));
    at += 4 * count;
    return found;
  };
  const found: { -readonly [Kind in "towns" | "countries" | "airfields" | "navaids"]: Cell[Kind] } = {
    towns: [],
    countries: [],
    airfields: [],
    navaids: [],
  };
  // In the order in which the tables stand in the text, and their places behind it.
  for (const kind of Object.keys(tables) as (keyof Tables)[]) {
    const places = positions(tables[kind]?.[0].length ?? 0);
    if (kind === "places") {
      const sizes = bytes.subarray(at, at + places.length);
      at += places.length;
      found.towns = places.map((where, index) => ({
        ...where,
        name: tables.places?.[0][index] ?? "",
        size: sizes[index] ?? 0,
      }));
    } else if (kind === "countries") {
      found.countries = places.map((where, index) => ({
        ...where,
        code: tables.countries?.[0][index] ?? "",
        area_km2: tables.countries?.[1][index] ?? 0,
      }));
    } else if (kind === "airfields") {
      found.airfields = places.map((where, index) => airfieldOf(tables, index, where));
    } else if (kind === "navaids") {
      found.navaids = places.map((where, index) => navaidOf(tables, index, where));
    }
  }
  const numbers = new VariableLength(bytes, at);
  return { place, land: shapesOf(numbers), borders: shapesOf(numbers), ...found };
}

export function westOf({ column, size_deg }: CellPlace): number {
  return column * size_deg - 180;
}

export function southOf({ row, size_deg }: CellPlace): number {
  return row * size_deg - 90;
}

function airfieldOf({ airfields }: Tables, index: number, at: Position): AirfieldAt {
  const [codes = [], names = [], elevations = [], kinds = [], weights = [], runways, frequencies] =
    airfields ?? [];
  return {
    ...at,
    code: codes[index] ?? "",
    name: names[index] ?? "",
    elevation_ft: elevations[index] ?? null,
    kind: kinds[index] ?? "",
    weight: weights[index] ?? 0,
    runways: runways?.[index]?.map((row) => runwayOf(row, at)) ?? null,
    frequencies:
      frequencies?.[index]?.map(([type, description, mhz]) => ({ type, description, mhz })) ?? null,
  };
}

function runwayOf([from, to, length_ft, width_ft, surface, lit, ends]: RunwayRow, at: Position): RunwayOf {
  const [from_x, from_y, to_x, to_y] = ends;
  const end = (x: number, y: number): Position => ({
    longitude_deg: at.longitude_deg + x / RUNWAY_UNITS,
    latitude_deg: at.latitude_deg + y / RUNWAY_UNITS,
  });
  const places =
    from_x === undefined || from_y === undefined || to_x === undefined || to_y === undefined
      ? null
      : ([end(from_x, from_y), end(to_x, to_y)] as const);
  return { ends: [from, to], length_ft, width_ft, surface, isLit: lit === 1, places };
}

function navaidOf({ navaids }: Tables, index: number, at: Position): NavaidAt {
  const [codes = [], names = [], types = [], frequencies = [], elevations = [], channels = []] =
    navaids ?? [];
  return {
    ...at,
    code: codes[index] ?? "",
    name: names[index] ?? "",
    type: types[index] ?? "",
    frequency_khz: frequencies[index] ?? null,
    elevation_ft: elevations[index] ?? null,
    dmeChannel: channels[index] || "",
  };
}

function shapesOf(numbers: VariableLength): Shapes {
  const count = numbers.next();
  const starts = new Int32Array(count + 1);
  const points: number[] = [];
  for (let shape = 0; shape < count; shape += 1) {
    const length = numbers.next();
    let [x, y] = [0, 0];
    for (let point = 0; point < length; point += 1) {
      x += numbers.nextSigned();
      y += numbers.nextSigned();
      points.push(x, y);
    }
    starts[shape + 1] = points.length / 2;
  }
  return { points: Int32Array.from(points), starts };
}

/** Numbers in groups of seven bits, the lowest first. */
class VariableLength {
  readonly #bytes: Uint8Array;
  #at: number;

  constructor(bytes: Uint8Array, at: number) {
    this.#bytes = bytes;
    this.#at = at;
  }

  next(): number {
    let number = 0;
    for (let shift = 0; shift < 32; shift += 7) {
      const group = this.#bytes[this.#at];
      if (group === undefined) {
        throw new RangeError("a cell of the map is cut off");
      }
      this.#at += 1;
      number |= (group & 0x7f) << shift;
      if (group < 0x80) {
        return number;
      }
    }
    throw new RangeError("a number in a cell of the map is too long");
  }

  nextSigned(): number {
    const number = this.next();
    return number % 2 === 0 ? number / 2 : -(number + 1) / 2;
  }
}
