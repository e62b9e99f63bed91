import { PrimitiveCollection } from "@cesium/engine";
import { beforeAll, expect, test, vi } from "vitest";
import type { Globe } from "../globe/Globe";
import type { SpaceText } from "../globe/GlobeLabels";
import type { DrawnPlan } from "../legs/shape";
import { PlanLayer } from "./PlanLayer";

const plan: DrawnPlan = {
  waypoints: [
    { latitude_deg: 27.95, longitude_deg: -15.37, altitude_ft: 700, speed_kt: 55 },
    { latitude_deg: 27.92, longitude_deg: -15.36, altitude_ft: 1000, speed_kt: 60 },
  ],
  board: null,
  unsent: [false, true],
  active: 1,
  loops: false,
  turnBank_deg: null,
  selected: 0,
  chosen: [0],
  label: (_, row) => String(row + 1),
};

// The engine checks for each colour of a line whether it is an image.
beforeAll(() => {
  for (const name of ["ImageBitmap", "OffscreenCanvas"]) {
    vi.stubGlobal(name, class {});
  }
  return () => vi.unstubAllGlobals();
});

/** What a layer needs of a globe, without its drawing. */
function bareGlobe() {
  const globe = {
    scene: { primitives: new PrimitiveCollection() },
    asked: 0,
    /** What each who draws has written. */
    written: new Map<object, readonly string[]>(),
    labels: { show: (_owner: object, _texts: readonly SpaceText[]): void => undefined },
    requestRender: () => undefined,
  };
  globe.labels.show = (owner, texts) => {
    globe.written.set(
      owner,
      texts.map(({ text }) => text),
    );
  };
  globe.requestRender = () => {
    globe.asked += 1;
  };
  return globe;
}

test("a plan is drawn anew when it is another one, and only then", () => {
  const globe = bareGlobe();
  const layer = new PlanLayer(globe as unknown as Globe, "hil");
  layer.show(plan);
  layer.show(plan);
  expect(globe.asked).toBe(1);
  layer.show({ ...plan, active: null });
  layer.show(null);
  expect(globe.asked).toBe(3);
});

test("what drew a plan is gone with it", () => {
  const globe = bareGlobe();
  const layer = new PlanLayer(globe as unknown as Globe, "flight");
  layer.show(plan);
  expect(globe.scene.primitives.length).toBe(2);
  expect(globe.written.get(layer)).toEqual(["1", "2"]);
  layer.dispose();
  expect(globe.scene.primitives.length).toBe(0);
  expect(globe.written.get(layer)).toEqual([]);
});
