import { Globe } from "./Globe";

let kept: Globe | null = null;

/** The page's one globe, made when it is first asked for. Throws where the browser has no WebGL. */
export function keptGlobe(): Globe {
  kept ??= new Globe();
  return kept;
}
