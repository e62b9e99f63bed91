import { vi } from "vitest";

/** The canvas functions that jsdom lacks and uPlot needs; nothing is drawn. */
class SilentPath {
  moveTo(): void {}
  lineTo(): void {}
  rect(): void {}
  arc(): void {}
  closePath(): void {}
  addPath(): void {}
}

class SilentObserver {
  observe(): void {}
  unobserve(): void {}
  disconnect(): void {}
}

/** A drawing context that takes every call and property, and measures text as seven pixels a letter. */
function silentContext(canvas: HTMLCanvasElement): CanvasRenderingContext2D {
  const set = new Map<PropertyKey, unknown>([["canvas", canvas]]);
  const context = new Proxy(
    {},
    {
      get: (_, name) => {
        if (set.has(name)) {
          return set.get(name);
        }
        return name === "measureText" ? (text: string) => ({ width: text.length * 7 }) : () => undefined;
      },
      set: (_, name, value) => {
        set.set(name, value);
        return true;
      },
    },
  );
  return context as CanvasRenderingContext2D;
}

export function installCanvas(): void {
  vi.stubGlobal("Path2D", SilentPath);
  vi.stubGlobal("ResizeObserver", SilentObserver);
  // A test that answers for a window of its own has done so already.
  window.matchMedia ??
    vi.stubGlobal("matchMedia", () => ({ matches: false, addEventListener() {}, removeEventListener() {} }));
  HTMLCanvasElement.prototype.getContext = function getContext(this: HTMLCanvasElement, kind: string) {
    // No WebGL: the page shows its fallback.
    return kind === "2d" ? silentContext(this) : null;
  } as unknown as typeof HTMLCanvasElement.prototype.getContext;
}
