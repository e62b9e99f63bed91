import { createContext, useContext, useEffect, useState } from "react";
import type { Globe } from "../../../scene/globe/Globe";

export const GlobeContext = createContext<Globe | null>(null);

/** The globe; null until its code is loaded, or if the browser cannot draw it. */
export function useGlobe(): Globe | null {
  return useContext(GlobeContext);
}

/** Something that draws on the globe. */
interface Layer {
  dispose(): void;
}

const layers = new WeakMap<Globe, Map<string, Promise<Layer>>>();

/**
 * A layer of the globe by its name: loaded and made on first use, and kept as long as the globe, even while the tab
 * is closed. `load` imports its class on demand, so that the page without a map does not load it. Null until it is
 * made.
 */
export function useGlobeLayer<L extends Layer>(
  name: string,
  load: () => Promise<new (globe: Globe) => L>,
): L | null {
  const globe = useGlobe();
  const [layer, setLayer] = useState<L | null>(null);
  // biome-ignore lint/correctness/useExhaustiveDependencies: a layer is loaded once for its name
  useEffect(() => {
    if (globe === null) {
      return undefined;
    }
    const made = layers.get(globe) ?? new Map<string, Promise<Layer>>();
    layers.set(globe, made);
    const promised = made.get(name) ?? load().then((Made) => owned(globe, new Made(globe)));
    made.set(name, promised);
    let isWanted = true;
    promised.then(
      (loaded) => isWanted && setLayer(loaded as L),
      // Tried again when the tab is opened next.
      () => made.delete(name),
    );
    return () => {
      isWanted = false;
      setLayer(null);
    };
  }, [globe, name]);
  return layer;
}

/** A layer is disposed of with its globe. */
function owned(globe: Globe, layer: Layer): Layer {
  globe.onDispose(() => layer.dispose());
  return layer;
}
