import { describe, expect, test } from "vitest";
import type { AirfieldAt, NavaidAt } from "../world/cell";
import type { NamedThing } from "../world/things";
import { countryNames, textOf } from "./thingTexts";

const AT = { x: 10, y: 20 };
const PLACE = { latitude_deg: 28, longitude_deg: -15 };
const BASE = { ...PLACE, key: "key", rank: 77 };

function airfield(more: Partial<AirfieldAt>): NamedThing {
  const field: AirfieldAt = {
    ...PLACE,
    code: "GCLP",
    name: "Gran Canaria",
    elevation_ft: 78,
    kind: "",
    weight: 4,
    runways: null,
    frequencies: null,
    ...more,
  };
  return { ...BASE, kind: "airfield", airfield: field };
}

function navaid(code: string, type: string): NamedThing {
  const aid: NavaidAt = {
    ...PLACE,
    code,
    name: "",
    type,
    frequency_khz: null,
    elevation_ft: null,
    dmeChannel: "",
  };
  return { ...BASE, kind: "navaid", navaid: aid };
}

function town(size: number): NamedThing {
  return { ...BASE, kind: "town", name: "Telde", size };
}

function shown(thing: NamedThing, light: "day" | "night" = "day") {
  return textOf(thing, AT, light, countryNames("es"));
}

test("a text stands at its thing's spot with its key and rank", () => {
  expect(shown(town(100))).toMatchObject({ key: "key", rank: 77, at: AT, isSought: false });
});

test("the more people a town has, the larger its name", () => {
  const sizes = [95, 96, 127, 128].map((size) => /(\d+)px/.exec(shown(town(size)).font)?.[1]);
  expect(sizes).toEqual(["12", "13", "13", "15"]);
});

test("a country has its name in the language of the page, in capitals, and no mark", () => {
  const country: NamedThing = { ...BASE, kind: "country", code: "DE" };
  expect(shown(country).text).toBe("ALEMANIA");
  expect(shown(country).mark).toBeUndefined();
  expect(textOf(country, AT, "day", countryNames("en")).text).toBe("GERMANY");
});

test("a country's code that the browser does not know is shown as it is", () => {
  expect(countryNames("es")("QX")).toBe("QX");
});

describe("an airfield", () => {
  test("is told by its code, and by its name where the code is only the source's own", () => {
    expect(shown(airfield({})).text).toBe("GCLP");
    expect(shown(airfield({ code: "ES-0123" })).text).toBe("Gran Canaria");
  });

  test("for airliners is written larger than a strip", () => {
    expect(shown(airfield({ weight: 3 })).font).toMatch(/^700 14px/);
    expect(shown(airfield({ weight: 2 })).font).toMatch(/^600 12px/);
  });

  test.each([
    ["", "airfield"],
    ["H", "heliport"],
    ["S", "water"],
    ["B", "airfield"],
  ])("of the kind %j has the mark %s", (kind, mark) => {
    expect(shown(airfield({ kind })).mark).toBe(mark);
  });
});

test("a radio beacon has its type behind its code, and the mark of its type", () => {
  expect(shown(navaid("GDV", "VOR-DME"))).toMatchObject({ text: "GDV VOR-DME", mark: "vor" });
  expect(shown(navaid("LPA", "NDB-DME"))).toMatchObject({ text: "LPA NDB-DME", mark: "ndb" });
});

test("at night every kind of name is dimmer than by day", () => {
  const light = (colour: string): number =>
    [1, 3, 5].reduce((sum, at) => sum + Number.parseInt(colour.slice(at, at + 2), 16), 0);
  const country: NamedThing = { ...BASE, kind: "country", code: "ES" };
  for (const thing of [town(100), country, airfield({}), navaid("GDV", "VOR")]) {
    expect(light(shown(thing, "night").colour)).toBeLessThan(light(shown(thing, "day").colour));
  }
});
