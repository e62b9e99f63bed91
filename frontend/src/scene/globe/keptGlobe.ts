import { Globe } from "./Globe";

let kept: Globe | null = null;
let tell: (() => void) | null = null;

/**
 * The page's one globe, made when it is first asked for. Throws where the browser has no WebGL. `onLost`: the browser
 * has taken its graphics away, and asking again makes another.
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
