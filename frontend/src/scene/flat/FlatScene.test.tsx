import { afterEach, beforeEach, describe, expect, test, vi } from "vitest";
import type { Position } from "../../lib/geodesy";
import { TrackPoints } from "../../lib/track/trackPoints";
import { ManualAnimationFrames } from "../../test/animationFrames";
import { installCanvas } from "../../test/canvas";
import { openFlatMap } from "../../test/flatMap";
import type { GroundPlace, MapTarget } from "../legs/target";
import type { AirfieldAt } from "../world/cell";
import type { NamedThing } from "../world/things";
import type { FlatAircraft } from "./flatThings";
import { fromScreen, toScreen } from "./projection";

const GANDO: Position = { latitude_deg: 27.93, longitude_deg: -15.38 };
const MIDDLE = { x: 400, y: 300 };
const CONTENTS = {
  layers: [],
  tracks: [],
  graticule: null,
  light: "day",
  countries: (code: string) => code,
} as const;
const AIRCRAFT: FlatAircraft = {
  plan: "flight",
  place: GANDO,
  heading_deg: 90,
  colour: "#ffd91a",
  label: "EPF-1",
  isLive: true,
};

function airfield(code: string, place: Position): NamedThing {
  const field: AirfieldAt = {
    ...place,
    code,
    name: "",
    elevation_ft: null,
    kind: "",
    weight: 4,
    runways: null,
    frequencies: null,
  };
  return { ...place, key: `a${code}`, rank: 100, kind: "airfield", airfield: field };
}

let frames: ManualAnimationFrames;
let resized: () => void;
let isWatched: boolean;

beforeEach(() => {
  installCanvas();
  frames = new ManualAnimationFrames();
  isWatched = true;
  vi.stubGlobal("requestAnimationFrame", frames.request);
  vi.stubGlobal("cancelAnimationFrame", frames.cancel);
  vi.stubGlobal(
    "ResizeObserver",
    class {
      constructor(hear: () => void) {
        resized = hear;
      }
      observe(): void {}
      disconnect(): void {
        isWatched = false;
      }
    },
  );
});
afterEach(() => {
  vi.unstubAllGlobals();
  document.body.replaceChildren();
});

/** A map of this size, over ground with these names. */
function open(size?: { width: number; height: number }, named?: NamedThing[]) {
  return openFlatMap(frames, size, named);
}

function expectPlace(found: Position | undefined, wanted: Position): void {
  expect(found?.latitude_deg).toBeCloseTo(wanted.latitude_deg, 6);
  expect(found?.longitude_deg).toBeCloseTo(wanted.longitude_deg, 6);
}

describe("the map's keys", () => {
  test.each([
    ["ArrowLeft", -80, 0],
    ["ArrowRight", 80, 0],
    ["ArrowUp", 0, -80],
    ["ArrowDown", 0, 80],
  ])("%s moves the map away from what it followed", (key, right_px, down_px) => {
    const { scene, seen, heard } = open();
    const before = seen();
    expect(scene.key(key)).toBe(true);
    expectPlace(seen().centre, fromScreen(before, { x: 400 + right_px, y: 300 + down_px }));
    expect(heard.onMoved).toHaveBeenCalledOnce();
  });

  test("plus and minus change the size about the middle, and go on following", () => {
    const { scene, seen, heard } = open();
    const { zoom, centre } = seen();
    scene.key("+");
    expect(seen().zoom).toBe(zoom + 1);
    scene.key("-");
    scene.key("-");
    expect(seen().zoom).toBe(zoom - 1);
    expectPlace(seen().centre, centre);
    expect(heard.onMoved).not.toHaveBeenCalled();
  });

  test("that mean nothing here are left to the page", () => {
    const { scene, seen } = open();
    const before = seen();
    expect(scene.key("x")).toBe(false);
    expect(seen()).toBe(before);
  });
});

describe("the map's size", () => {
  test("on a fine screen is that of its pixels", () => {
    vi.stubGlobal("devicePixelRatio", 2);
    const { canvas, size } = open();
    expect([canvas.width, canvas.height]).toEqual([1600, 1200]);
    size.width = 500;
    resized();
    expect(canvas.width).toBe(1000);
  });

  test("is awaited before places are shown, and then all of them are", () => {
    const { scene, size, seen } = open({ width: 0, height: 0 });
    const places = [GANDO, { latitude_deg: 28.2, longitude_deg: -15.9 }];
    scene.lookAt(places);
    resized();
    Object.assign(size, { width: 800, height: 600 });
    resized();
    for (const place of places) {
      const { x, y } = toScreen(seen(), place);
      expect(Math.min(x, 800 - x, y, 600 - y)).toBeGreaterThan(50);
    }
    const elsewhere = { latitude_deg: 40.4, longitude_deg: -3.7 };
    scene.centreOn(elsewhere);
    size.width = 700;
    resized();
    // Shown once: later the map stays where a person has moved it.
    expect(seen().centre).toEqual(elsewhere);
  });

  test("is drawn once in the next picture, however much has changed", () => {
    const { scene, draw } = open();
    scene.zoom(1);
    scene.centreOn(GANDO);
    expect(frames.waiting).toBe(1);
    expect(draw()).toBe(true);
    expect(draw()).toBe(false);
  });
});

describe("an aircraft", () => {
  test("that is followed stays in the middle, and the wheel does not move it away", () => {
    const { scene, seen, wheel, heard } = open();
    const on = { latitude_deg: 28.1, longitude_deg: -15.5 };
    scene.setAircraft([{ ...AIRCRAFT, place: on }], on);
    expect(seen().centre).toEqual(on);
    const { zoom } = seen();
    wheel(100, 100, -400);
    expect(seen().zoom).toBe(zoom + 1);
    expectPlace(seen().centre, on);
    expect(heard.onMoved).not.toHaveBeenCalled();
  });

  test("that is not followed leaves the map where it is, and what lies under the wheel stays there", () => {
    const { scene, seen, wheel } = open();
    const before = seen();
    scene.setAircraft([AIRCRAFT], null);
    expect(seen()).toBe(before);
    const held = fromScreen(before, { x: 100, y: 100 });
    wheel(100, 100, -400);
    const { x, y } = toScreen(seen(), held);
    expect(x).toBeCloseTo(100, 6);
    expect(y).toBeCloseTo(100, 6);
  });

  test("is drawn where it is and turned as it flies", () => {
    const { scene, calls, draw, seen } = open();
    scene.setAircraft([AIRCRAFT], null);
    draw();
    const { x, y } = toScreen(seen(), GANDO);
    expect(calls).toContainEqual(["translate", x, y]);
    expect(calls).toContainEqual(["rotate", Math.PI / 2]);
  });

  test("that has not changed needs no new picture, unless its track has grown", () => {
    const { scene, draw } = open();
    const points = new TrackPoints();
    const look = { plain: "#ffd91a", casing: "#12100a", colouring: "none", range: null } as const;
    scene.setContents({ ...CONTENTS, tracks: [{ points, look }] });
    scene.setAircraft([AIRCRAFT], null);
    draw();
    scene.setAircraft([{ ...AIRCRAFT }], null);
    expect(draw()).toBe(false);
    points.add({ t_s: 1, latitude_e7: 279_300_000, longitude_e7: -153_800_000, altitude_mm: 300_000 });
    scene.setAircraft([AIRCRAFT], null);
    expect(draw()).toBe(true);
    scene.setAircraft([{ ...AIRCRAFT, heading_deg: 91 }], null);
    expect(draw()).toBe(true);
  });
});

describe("a hand on the map", () => {
  test("pushes it away from what it followed", () => {
    const { send, seen, heard } = open();
    const held = fromScreen(seen(), { x: 200, y: 200 });
    send("pointerdown", 200, 200);
    send("pointermove", 260, 230);
    send("pointerup", 260, 230);
    const { x, y } = toScreen(seen(), held);
    expect(x).toBeCloseTo(260, 6);
    expect(y).toBeCloseTo(230, 6);
    expect(heard.onMoved).toHaveBeenCalled();
  });

  test("over it is told as a place, and none when it has gone", () => {
    const { send, seen, heard } = open();
    send("pointermove", 123, 45);
    expectPlace(heard.onPointer.mock.lastCall?.[0], fromScreen(seen(), { x: 123, y: 45 }));
    send("pointerleave", 0, 0);
    expect(heard.onPointer).toHaveBeenLastCalledWith(null);
  });

  test("that would put something there has a cross for a pointer", () => {
    const { scene, send, canvas } = open();
    send("pointermove", 10, 10);
    expect(canvas.style.cursor).toBe("");
    scene.aim(true);
    send("pointermove", 11, 10);
    expect(canvas.style.cursor).toBe("crosshair");
    scene.aim(false);
    send("pointermove", 12, 10);
    expect(canvas.style.cursor).toBe("");
  });

  test("tells taps and the other button with the place that lies there", () => {
    const { scene, send, seen } = open();
    const told: [string, MapTarget][] = [];
    const hear = (name: string) => (target: MapTarget) => void told.push([name, target]);
    scene.plans.listen({
      pick: vi.fn(),
      drag: vi.fn(),
      drop: vi.fn(),
      tap: hear("tap"),
      double: hear("double"),
      menu: hear("menu"),
    });
    send("pointerdown", 150, 250);
    send("pointerup", 150, 250);
    send("pointerdown", 150, 250);
    send("pointerup", 150, 250);
    send("pointerdown", 150, 250, { button: 2 });
    send("pointerup", 150, 250, { button: 2 });
    expect(told.map(([name]) => name)).toEqual(["tap", "double", "menu"]);
    for (const [, { place }] of told) {
      expectPlace(place ?? undefined, fromScreen(seen(), { x: 150, y: 250 }));
    }
  });

  test("finds the aircraft that lies there", () => {
    const { scene } = open();
    scene.setAircraft([AIRCRAFT], GANDO);
    scene.plans.listen({
      pick: vi.fn(),
      drag: vi.fn(),
      drop: vi.fn(),
      tap: vi.fn(),
      double: vi.fn(),
      menu: vi.fn(),
    });
    expect(scene.targetAt(MIDDLE).thing).toEqual({ kind: "aircraft", plan: "flight" });
    expect(scene.targetAt({ x: 10, y: 10 }).thing).toBeNull();
  });
});

describe("the names of the ground", () => {
  test("are asked for around the middle, and an airfield's can be pressed", async () => {
    const { questions, draw, send, heard, canvas } = open({ width: 800, height: 600 }, [
      airfield("GCLP", GANDO),
    ]);
    draw();
    const asked = questions.find(({ kind }) => kind === "things");
    expect(asked).toMatchObject({ centre: GANDO });
    await expect.poll(() => frames.waiting).toBe(1);
    draw();
    send("pointermove", 400, 300);
    expect(canvas.style.cursor).toBe("pointer");
    send("pointerdown", 400, 300);
    send("pointerup", 400, 300);
    expect(heard.onAirfield).toHaveBeenCalledExactlyOnceWith({ code: "GCLP", ...GANDO });
    send("pointerdown", 40, 40);
    send("pointerup", 40, 40);
    expect(heard.onAirfield).toHaveBeenCalledOnce();
  });

  test("give way to measuring: a press is then a place, also on an airfield", async () => {
    const { scene, draw, send, heard } = open({ width: 800, height: 600 }, [airfield("GCLP", GANDO)]);
    draw();
    await expect.poll(() => frames.waiting).toBe(1);
    draw();
    const measured: GroundPlace[] = [];
    scene.measure((place) => measured.push(place));
    send("pointerdown", 400, 300);
    send("pointerup", 400, 300);
    expect(measured).toHaveLength(1);
    expectPlace(measured[0], GANDO);
    expect(measured[0]?.height_m).toBeNull();
    scene.measure(null);
    send("pointerdown", 400, 300);
    send("pointerup", 400, 300);
    expect(measured).toHaveLength(1);
    expect(heard.onAirfield).toHaveBeenCalledOnce();
  });

  test("are not asked for by a map without a size", () => {
    const { questions, draw } = open({ width: 0, height: 0 });
    draw();
    expect(questions.filter(({ kind }) => kind === "things")).toEqual([]);
  });
});

test("the ground is asked for in the light of the day or of the night", () => {
  const { scene, questions, draw } = open();
  draw();
  const lights = () => [
    ...new Set(questions.flatMap((question) => (question.kind === "tile" ? [question.light] : []))),
  ];
  expect(lights()).toEqual(["day"]);
  questions.length = 0;
  scene.setContents({ ...CONTENTS, light: "night" });
  draw();
  expect(lights()).toEqual(["night"]);
});

test("measured distances, areas and lines of latitude are drawn when they are shown, and no longer when not", () => {
  const { scene, calls, draw } = open();
  const strokes = (): number => {
    expect(draw()).toBe(true);
    return calls.filter(([name]) => name === "stroke").length;
  };
  const bare = strokes();
  const line = [
    { ...GANDO, label: "0" },
    { latitude_deg: 27.95, longitude_deg: -15.4, label: "2.4 km" },
  ];
  scene.showDistance(line);
  const measured = strokes();
  expect(measured).toBeGreaterThan(bare);
  scene.showArea(line);
  expect(strokes()).toBe(2 * measured - bare);
  scene.showDistance([]);
  scene.showArea([]);
  expect(strokes()).toBe(bare);
  scene.setContents({ ...CONTENTS, graticule: { north: "N", south: "S", east: "E", west: "W" } });
  expect(strokes()).toBeGreaterThan(bare);
});

test("the middle of the picture is the place that was put there", () => {
  const { scene, seen } = open();
  const { zoom } = seen();
  const place = { latitude_deg: 40.4, longitude_deg: -3.7 };
  scene.centreOn(place);
  scene.zoom(2);
  expectPlace(scene.centre(), place);
  expect(scene.centre().height_m).toBeNull();
  expect(seen().zoom).toBe(zoom + 2);
});

test("a map that is no longer there draws nothing more and hears no hand", () => {
  const { scene, send, heard } = open();
  scene.dispose();
  expect(frames.waiting).toBe(0);
  expect(isWatched).toBe(false);
  send("pointermove", 10, 10);
  expect(heard.onPointer).not.toHaveBeenCalled();
});

test("a canvas that cannot be drawn on is left alone", () => {
  const { canvas, questions } = open();
  canvas.getContext = () => null;
  frames.show(0);
  expect(questions).toEqual([]);
});
