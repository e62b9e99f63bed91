import { vi } from "vitest";
import { FlatScene } from "../scene/flat/FlatScene";
import type { FlatView } from "../scene/flat/projection";
import type { WorldQuestion } from "../scene/world/messages";
import type { NamedThing } from "../scene/world/things";
import type { World } from "../scene/world/World";
import type { ManualAnimationFrames } from "./animationFrames";

/** What was drawn with a context: each call with its arguments. */
function recording(canvas: HTMLCanvasElement) {
  const calls: [name: string, ...args: unknown[]][] = [];
  const context = new Proxy(
    { canvas },
    {
      get: (held, name) =>
        name in held
          ? Reflect.get(held, name)
          : (...args: unknown[]) => void calls.push([String(name), ...args]),
    },
  );
  canvas.getContext = (() => context) as unknown as HTMLCanvasElement["getContext"];
  return calls;
}

/** A map of 800 by 600 pixels, and what it tells. */
export function openFlatMap(
  frames: ManualAnimationFrames,
  size = { width: 800, height: 600 },
  named: NamedThing[] = [],
) {
  const canvas = document.createElement("canvas");
  canvas.setPointerCapture = () => undefined;
  Object.defineProperties(canvas, {
    clientWidth: { get: () => size.width },
    clientHeight: { get: () => size.height },
  });
  document.body.append(canvas);
  const calls = recording(canvas);
  const questions: WorldQuestion[] = [];
  const world = {
    ask: (question: WorldQuestion) => {
      questions.push(question);
      return question.kind === "things" ? Promise.resolve(named) : new Promise(() => undefined);
    },
  };
  let view: FlatView | null = null;
  const heard = { onPointer: vi.fn(), onMoved: vi.fn(), onAirfield: vi.fn() };
  const scene = new FlatScene(canvas, world as unknown as World, {
    ...heard,
    onView: (seen) => {
      view = seen;
    },
  });
  const send = (type: string, x: number, y: number, more: PointerEventInit = {}): void => {
    const event = new PointerEvent(type, {
      pointerId: 1,
      pointerType: "mouse",
      isPrimary: true,
      button: 0,
      bubbles: true,
      ...more,
    });
    Object.defineProperties(event, { offsetX: { value: x }, offsetY: { value: y } });
    canvas.dispatchEvent(event);
  };
  const wheel = (x: number, y: number, deltaY: number): void => {
    const event = new WheelEvent("wheel", { deltaY, bubbles: true, cancelable: true });
    Object.defineProperties(event, { offsetX: { value: x }, offsetY: { value: y } });
    canvas.dispatchEvent(event);
  };
  /** Draws what has changed; says whether anything had. */
  const draw = (): boolean => {
    const isDue = frames.waiting > 0;
    calls.length = 0;
    frames.show(0);
    return isDue;
  };
  const seen = (): FlatView => {
    if (view === null) {
      throw new Error("no view was told");
    }
    return view;
  };
  return { scene, canvas, size, calls, questions, heard, send, wheel, draw, seen };
}
