import { type RefObject, useCallback, useEffect, useRef, useState } from "react";
import type { Globe } from "../../../scene/globe/Globe";
import { hasWebgl } from "../../../scene/graphics";
import { usePage } from "../../../store/hooks";
import { choose } from "../../../store/settings";

/** Stored, so that the engine is preloaded the next time. */
export const MAP_OPENED_CHOICE = "map.opened";

/** Why there is no globe: its code was not loaded, there is no WebGL, or the graphics context was lost. */
export type GlobeProblem = "notLoaded" | "noWebgl" | "lost";

interface KeptGlobe {
  readonly globe: Globe | null;
  readonly problem: GlobeProblem | null;
  readonly retry: () => void;
}

/** If the graphics context is lost again within this time, do not recover by ourselves. */
const AGAIN_MS = 60_000;
/** The browser restores a lost context after a moment. */
const RECOVER_MS = 1500;

/** Puts the page's one globe into this host while it is shown; does nothing while `isWanted` is false. */
export function useKeptGlobe(host: RefObject<HTMLElement | null>, isWanted: boolean): KeptGlobe {
  const { settings } = usePage();
  const [globe, setGlobe] = useState<Globe | null>(null);
  const [problem, setProblem] = useState<GlobeProblem | null>(null);
  const [attempt, setAttempt] = useState(0);
  const lost_ms = useRef(Number.NEGATIVE_INFINITY);
  const retry = useCallback(() => setAttempt((count) => count + 1), []);
  // biome-ignore lint/correctness/useExhaustiveDependencies: each attempt asks anew
  useEffect(() => {
    if (!isWanted) {
      setProblem(null);
      return undefined;
    }
    if (!hasWebgl()) {
      setProblem("noWebgl");
      return undefined;
    }
    let isHere = true;
    let shown: Globe | null = null;
    let recovery: ReturnType<typeof setTimeout> | undefined;
    const lose = (): void => {
      shown = null;
      setGlobe(null);
      setProblem("lost");
      const now_ms = performance.now();
      if (now_ms - lost_ms.current > AGAIN_MS) {
        recovery = setTimeout(retry, RECOVER_MS);
      }
      lost_ms.current = now_ms;
    };
    const show = (keptGlobe: (onLost: () => void) => Globe): void => {
      if (!isHere || host.current === null) {
        return;
      }
      try {
        shown = keptGlobe(lose);
      } catch {
        setProblem("noWebgl");
        return;
      }
      shown.attach(host.current);
      setGlobe(shown);
      setProblem(null);
      choose(settings, MAP_OPENED_CHOICE, "yes");
    };
    import("../../../scene/globe/keptGlobe").then(
      (module) => show(module.keptGlobe),
      () => isHere && setProblem("notLoaded"),
    );
    return () => {
      isHere = false;
      clearTimeout(recovery);
      shown?.detach();
      setGlobe(null);
    };
  }, [host, settings, retry, attempt, isWanted]);
  return { globe, problem, retry };
}
