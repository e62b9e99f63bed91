import type { Spot } from "../../lib/labels";
import type { ShownText } from "../labels/LabelSheet";
import type { Mark } from "../labels/marks";
import type { Light } from "../look";
import type { NamedThing } from "../world/things";

const FAMILY = '"Inter Variable", system-ui, sans-serif';
/** Towns of 65,000 people, and of 4,000, in the measure of their size. */
const LARGE = 128;
const SMALL = 96;

const INK: Readonly<Record<Light, Readonly<Record<NamedThing["kind"], string>>>> = {
  day: { town: "#ffffff", country: "#ffe9b8", airfield: "#a9e0ff", navaid: "#dcc9ff" },
  night: { town: "#b9c4be", country: "#b8a67c", airfield: "#6fa9c9", navaid: "#9b8bbd" },
};

/** The text of a thing beside its spot on the picture; countries in the user's language. */
export function textOf(thing: NamedThing, at: Spot, light: Light, countries: CountryNames): ShownText {
  const common = { key: thing.key, rank: thing.rank, at, isSought: false, colour: INK[light][thing.kind] };
  switch (thing.kind) {
    case "town":
      return { ...common, text: thing.name, font: townFont(thing.size), away_px: 5, mark: "town" };
    case "country": {
      const text = countries(thing.code).toLocaleUpperCase();
      return { ...common, text, font: `700 14px ${FAMILY}`, away_px: 0 };
    }
    case "airfield": {
      const { code, name, kind, weight } = thing.airfield;
      // A code with a hyphen is the source's own and says nothing to a pilot.
      const text = /^[A-Z0-9]{3,4}$/.test(code) ? code : name;
      const font = `${weight >= 3 ? 700 : 600} ${weight >= 3 ? 14 : 12}px ${FAMILY}`;
      return { ...common, text, font, away_px: 9, mark: airfieldMark(kind) };
    }
    case "navaid": {
      const { code, type } = thing.navaid;
      const mark = type.startsWith("NDB") ? "ndb" : "vor";
      return { ...common, text: `${code} ${type}`, font: `500 11px ${FAMILY}`, away_px: 9, mark };
    }
  }
}

/** A country's name by its ISO 3166 code. */
export type CountryNames = (code: string) => string;

/** Names in a language of the browser; a code that it does not know stays. */
export function countryNames(language: string): CountryNames {
  const names = new Intl.DisplayNames([language], { type: "region", fallback: "code" });
  return (code) => names.of(code) ?? code;
}

function townFont(size: number): string {
  if (size >= LARGE) {
    return `650 15px ${FAMILY}`;
  }
  return size >= SMALL ? `550 13px ${FAMILY}` : `500 12px ${FAMILY}`;
}

function airfieldMark(kind: string): Mark {
  return kind === "H" ? "heliport" : kind === "S" ? "water" : "airfield";
}
