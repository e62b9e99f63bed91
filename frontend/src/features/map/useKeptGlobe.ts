import { type RefObject, useCallback, useEffect, useRef, useState } from "react";
import type { Globe } from "../../scene/globe/Globe";
import { hasWebgl } from "../../scene/graphics";
import { usePage } from "../../store/hooks";
import { choose } from "../../store/settings";

/** Remembered, so that its engine is fetched ahead the next time. */
export const MAP_OPENED_CHOICE = "map.opened";

/** Why there is no globe: its code could not be fetched, the browser cannot draw it, or has stopped drawing it. */
export type GlobeProblem = "notLoaded" | "noWebgl" | "lost";

interface KeptGlobe {
  readonly globe: Globe | null;
  readonly problem: GlobeProblem | null;
  readonly retry: () => void;
}

/** Graphics that are lost again within this time are not asked for by themselves another time. */
const AGAIN_MS = 60_000;
/** The browser gives them back after a moment. */
const RECOVER_MS = 1500;

/** The page's globe in this host for as long as the host is shown; nothing while `isWanted` is false. */
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
    import("../../scene/globe/keptGlobe").then(
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
