import { Globe } from "./Globe";

let kept: Globe | null = null;
let tell: (() => void) | null = null;

/**
 * The page's one globe, made on first use. Throws without WebGL. `onLost`: the browser has taken the graphics context
 * away; the next call makes a new globe.
 */
export function keptGlobe(onLost: () => void): Globe {
  tell = onLost;
  kept ??= new Globe(() => {
    kept?.dispose();
    kept = null;
    tell?.();
  });
  return kept;
}
