import { useEffect, useState } from "react";
import type { Plot } from "../ui/Plot";

interface LazyPlot {
  readonly Plot: typeof Plot | null;
  /** The drawing code could not be loaded; the browser tries again only after a reload. */
  readonly failed: boolean;
}

/** The plot library, loaded when the first plot is shown. */
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
