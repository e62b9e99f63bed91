import { useEffect, useState } from "react";
import type { Plot } from "../ui/Plot";

interface LazyPlot {
  readonly Plot: typeof Plot | null;
  /** The drawing could not be fetched; the browser asks again when the page is loaded again. */
  readonly failed: boolean;
}

/** The drawing library, fetched when the first plot is shown; a page without plots never pays for it. */
export function useLazyPlot(): LazyPlot {
  const [state, setState] = useState<LazyPlot>({ Plot: null, failed: false });
  useEffect(() => {
    let isWanted = true;
    const settle = (settled: LazyPlot): void => {
      if (isWanted) {
        setState(settled);
      }
    };
    import("../ui/Plot").then(
      (module) => settle({ Plot: module.Plot, failed: false }),
      () => settle({ Plot: null, failed: true }),
    );
    return () => {
      isWanted = false;
    };
  }, []);
  return state;
}
