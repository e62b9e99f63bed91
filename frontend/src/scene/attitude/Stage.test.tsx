import { PerspectiveCamera, Scene } from "three";
import { beforeEach, describe, expect, test, vi } from "vitest";
import { quaternionOf } from "../../lib/attitude";
import { AttitudeMotion } from "../../lib/attitudeMotion";
import { HandFrames } from "../../test/frames";
import { type Act, type Drawer, Stage } from "./Stage";

class CountingDrawer implements Drawer {
  readonly canvas = document.createElement("canvas");
  isSoftware = false;
  /** What a frame takes, and the time. */
  takes_ms = 0;
  now_ms = 0;
  #free_ms = Number.NEGATIVE_INFINITY;
  rendered = 0;
  disposed = false;
  sizes: Array<readonly [number, number]> = [];
  isBusy = (): boolean => this.now_ms < this.#free_ms;
  render = (): void => {
    this.#free_ms = this.now_ms + this.takes_ms;
    this.rendered += 1;
  };
  setSize = (width: number, height: number): void => {
    this.sizes.push([width, height]);
  };
  dispose = (): void => {
    this.disposed = true;
  };
}

class StillAct implements Act {
  readonly scene = new Scene();
  readonly camera = new PerspectiveCamera();
  /** How many frames it still goes on changing by itself. */
  moves = 0;
  advance = (): boolean => {
    this.moves -= 1;
    return this.moves > 0;
  };
}

let drawer: CountingDrawer;
let frames: HandFrames;
let stage: Stage;
let act: StillAct;
let host: HTMLElement;

beforeEach(() => {
  drawer = new CountingDrawer();
  frames = new HandFrames();
  stage = new Stage(drawer, frames);
  act = new StillAct();
  host = document.createElement("div");
  document.body.append(host);
});

/** Displayed frames of 60 Hz from `from_ms` on. */
function display(count: number, from_ms: number): void {
  for (let index = 0; index < count; index += 1) {
    drawer.now_ms = from_ms + (index * 1000) / 60;
    frames.show(drawer.now_ms);
  }
}

describe("what nobody changed", () => {
  test("is drawn once when it is shown, and then asks for no frame", () => {
    stage.show(act, host);
    display(60, 0);
    expect(drawer.rendered).toBe(1);
    expect(frames.waiting).toBe(0);
  });

  test("is drawn once more for each change, however many come before a frame", () => {
    stage.show(act, host);
    display(1, 0);
    stage.invalidate();
    stage.invalidate();
    display(10, 100);
    expect(drawer.rendered).toBe(2);
    expect(frames.waiting).toBe(0);
  });

  test("is drawn as long as it moves by itself, and not longer", () => {
    act.moves = 5;
    stage.show(act, host);
    display(60, 0);
    expect(drawer.rendered).toBe(5);
    expect(frames.waiting).toBe(0);
  });

  test("costs nothing while it is not shown", () => {
    stage.show(act, host);
    display(1, 0);
    stage.hide();
    stage.invalidate();
    display(10, 100);
    expect(drawer.rendered).toBe(1);
    expect(frames.waiting).toBe(0);
    expect(host.children).toHaveLength(0);
  });
});

test("a real motion comes to rest within a second and a half of its last sample", () => {
  const motion = new AttitudeMotion();
  motion.push(quaternionOf({ yaw_deg: 0, pitch_deg: 0, roll_deg: 0 }), 0);
  motion.push(quaternionOf({ yaw_deg: 0, pitch_deg: 0, roll_deg: 30 }), 100);
  const moving: Act = { ...act, advance: (now_ms) => motion.isMoving(now_ms, true) };
  stage.show(moving, host);
  display(90, 100);
  expect(frames.waiting).toBe(0);
  expect(drawer.rendered).toBeGreaterThan(60);
});

describe("drawn by the processor", () => {
  beforeEach(() => {
    drawer.isSoftware = true;
    act.moves = 1000;
    stage.show(act, host);
  });

  test("is drawn thirty times a second at the most", () => {
    display(61, 0);
    expect(drawer.rendered).toBeGreaterThan(25);
    expect(drawer.rendered).toBeLessThanOrEqual(31);
  });

  test("waits until a dear frame is finished, and then as long again", () => {
    drawer.takes_ms = 80;
    display(180, 0);
    const before = drawer.rendered;
    display(120, 3000);
    expect(drawer.rendered - before).toBeGreaterThan(8);
    expect(drawer.rendered - before).toBeLessThanOrEqual(12);
  });
});

test("with a graphics processor it is drawn in each frame", () => {
  act.moves = 1000;
  stage.show(act, host);
  display(60, 0);
  expect(drawer.rendered).toBe(60);
});

test("one canvas is moved to where it is shown", () => {
  const other = document.createElement("div");
  stage.show(act, host);
  stage.hide();
  stage.show(act, other);
  expect(host.children).toHaveLength(0);
  expect([...other.children]).toEqual([drawer.canvas]);
  stage.dispose();
  expect(other.children).toHaveLength(0);
  expect(drawer.disposed).toBe(true);
});

test("a picture that the browser takes away is asked back, and drawn again when it comes", () => {
  const told = vi.fn();
  stage.onLost = told;
  stage.show(act, host);
  display(1, 0);
  const lost = new Event("webglcontextlost", { cancelable: true });
  drawer.canvas.dispatchEvent(lost);
  expect(lost.defaultPrevented).toBe(true);
  stage.invalidate();
  display(10, 100);
  expect(drawer.rendered).toBe(1);
  drawer.canvas.dispatchEvent(new Event("webglcontextrestored"));
  display(10, 300);
  expect(drawer.rendered).toBe(2);
  expect(told.mock.calls).toEqual([[true], [false]]);
});
