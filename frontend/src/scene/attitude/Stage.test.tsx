import { PerspectiveCamera, Scene } from "three";
import { beforeEach, describe, expect, test, vi } from "vitest";
import { quaternionOf } from "../../lib/attitude";
import { AttitudeMotion } from "../../lib/attitudeMotion";
import { ManualAnimationFrames } from "../../test/animationFrames";
import { type Act, type Drawer, Stage } from "./Stage";

class CountingDrawer implements Drawer {
  readonly canvas = document.createElement("canvas");
  readonly picture = this.canvas;
  isSoftware = false;
  /** Duration of a picture, and the time. */
  takes_ms = 0;
  now_ms = 0;
  #free_ms = Number.NEGATIVE_INFINITY;
  #started_ms: number | null = null;
  rendered = 0;
  /** Number of pictures that were allowed to be coarse. */
  coarse = 0;
  prepared: Scene[] = [];
  disposed = false;
  sizes: Array<readonly [number, number]> = [];
  get isWaiting(): boolean {
    return this.now_ms < this.#free_ms;
  }
  prepare = (scene: Scene): void => {
    this.prepared.push(scene);
    this.#free_ms = this.now_ms + this.takes_ms;
  };
  settle = (): number | null => {
    const started_ms = this.#started_ms;
    if (this.isWaiting || started_ms === null) {
      return null;
    }
    this.#started_ms = null;
    return this.now_ms - started_ms;
  };
  render = (_scene: Scene, _camera: PerspectiveCamera, isMoving: boolean): void => {
    this.#started_ms = this.now_ms;
    this.#free_ms = this.now_ms + this.takes_ms;
    this.rendered += 1;
    this.coarse += isMoving ? 1 : 0;
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
  isDressed = true;
  /** Number of pictures during which it continues to change by itself. */
  moves = 0;
  advance = (): boolean => {
    this.moves -= 1;
    return this.moves > 0;
  };
}

let drawer: CountingDrawer;
let frames: ManualAnimationFrames;
let stage: Stage;
let act: StillAct;
let host: HTMLElement;

beforeEach(() => {
  drawer = new CountingDrawer();
  frames = new ManualAnimationFrames();
  stage = new Stage(drawer, frames);
  act = new StillAct();
  host = document.createElement("div");
  document.body.append(host);
});

/** Animation frames at 60 Hz from `from_ms` on. */
function display(count: number, from_ms: number): void {
  for (let index = 0; index < count; index += 1) {
    drawer.now_ms = from_ms + (index * 1000) / 60;
    frames.show(drawer.now_ms);
  }
}

describe("what nobody changed", () => {
  test("is drawn once when it is shown, and then asks for no animation frame", () => {
    stage.show(act, host);
    display(60, 0);
    expect(drawer.rendered).toBe(1);
    expect(frames.waiting).toBe(0);
  });

  test("is drawn once more for each change, however many come before an animation frame", () => {
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
    stage = new Stage(drawer, frames);
    act.moves = Number.POSITIVE_INFINITY;
    stage.show(act, host);
  });

  /** Number of pictures drawn in this many animation frames from then on. */
  function drawnIn(displayed: number, from_ms: number): number {
    const before = drawer.rendered;
    display(displayed, from_ms);
    return drawer.rendered - before;
  }

  test("is drawn a dozen times a second at the most", () => {
    drawer.takes_ms = 10;
    display(180, 0);
    const drawn = drawnIn(60, 3000);
    expect(drawn).toBeGreaterThan(8);
    expect(drawn).toBeLessThanOrEqual(13);
  });

  test("is drawn more often while a person turns it, and no longer than that", () => {
    drawer.takes_ms = 10;
    display(240, 0);
    let turned = 0;
    for (let at_ms = 4000; at_ms < 5000; at_ms += 100) {
      stage.turn(at_ms);
      turned += drawnIn(6, at_ms);
    }
    expect(turned).toBeGreaterThan(15);
    display(60, 5000);
    expect(drawnIn(60, 6000)).toBeLessThanOrEqual(13);
  });

  test("waits until a dear frame is finished, and leaves more than as long again to all else", () => {
    drawer.takes_ms = 200;
    display(240, 0);
    const drawn = drawnIn(120, 4000);
    expect(drawn).toBeGreaterThan(2);
    expect(drawn).toBeLessThanOrEqual(5);
  });

  test("is coarse while it moves, fine once it rests, and then not drawn any more", () => {
    display(60, 0);
    expect(drawer.coarse).toBe(drawer.rendered);
    act.moves = 1;
    display(60, 1000);
    expect(drawer.rendered).toBe(drawer.coarse + 1);
    expect(frames.waiting).toBe(0);
    const before = drawer.rendered;
    stage.invalidate();
    display(60, 2000);
    expect(drawer.rendered).toBe(before + 2);
    expect(drawer.rendered).toBe(drawer.coarse + 2);
  });
});

describe("before the first frame", () => {
  test("what has no colours yet is not drawn", () => {
    act.isDressed = false;
    stage.show(act, host);
    display(10, 0);
    expect(drawer.prepared).toHaveLength(0);
    expect(frames.waiting).toBe(0);
    act.isDressed = true;
    stage.invalidate();
    display(10, 200);
    expect(drawer.rendered).toBe(1);
  });

  test("what drawing needs is made, once for each that is shown; the one before is not seen meanwhile", () => {
    const other = new StillAct();
    drawer.takes_ms = 100;
    stage.show(act, host);
    display(3, 0);
    expect(drawer.prepared).toEqual([act.scene]);
    expect(drawer.rendered).toBe(0);
    display(20, 50);
    expect(drawer.rendered).toBe(1);
    expect(drawer.canvas.style.visibility).toBe("");
    stage.show(other, host);
    display(3, 1000);
    expect(drawer.prepared).toEqual([act.scene, other.scene]);
    expect(drawer.canvas.style.visibility).toBe("hidden");
    display(20, 1050);
    expect(drawer.canvas.style.visibility).toBe("");
    stage.show(act, host);
    display(20, 2000);
    expect(drawer.prepared).toHaveLength(2);
    expect(drawer.rendered).toBe(3);
  });
});

test("with a graphics processor it is drawn in each frame, as fine as at rest", () => {
  act.moves = 1000;
  stage.show(act, host);
  display(60, 0);
  expect(drawer.rendered).toBe(60);
  expect(drawer.coarse).toBe(0);
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
