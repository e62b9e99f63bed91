import { type RefObject, useCallback, useEffect, useState } from "react";
import type { OrbitRig } from "../../scene/attitude/OrbitRig";
import type { Palette } from "../../scene/attitude/palette";
import type { Act, Stage } from "../../scene/attitude/Stage";
import { paletteOf } from "./themePalette";

/** A scene with a camera that the user can turn. */
export interface TurnedAct extends Act {
  readonly rig: OrbitRig;
}

type StageModule = typeof import("../../scene/attitude/keptStage");

/** Why there is no picture: no WebGL, its context was lost, or its code could not be loaded. */
export type PictureProblem = "noWebgl" | "lost" | "notLoaded";

export interface StagePicture<A> {
  /** Null until it is loaded, or if it cannot be drawn. */
  readonly picture: { readonly act: A; readonly stage: Stage } | null;
  readonly problem: PictureProblem | null;
  /** Try again with a new stage. */
  readonly retry: () => void;
}

/**
 * The page's one 3D stage in this element, showing what `choose` picks, for as long as the component is there. `choose`
 * and `dress` must be stable; `dress` is called again when the theme changes.
 */
export function useStage<A extends TurnedAct>(
  host: RefObject<HTMLElement | null>,
  choose: (kept: StageModule) => A,
  dress: (act: A, palette: Palette) => void,
): StagePicture<A> {
  const [picture, setPicture] = useState<StagePicture<A>["picture"]>(null);
  const [problem, setProblem] = useState<PictureProblem | null>(null);
  const [attempt, setAttempt] = useState(0);

  useEffect(() => {
    let isWanted = true;
    let leave = (): void => undefined;

    function enter(kept: StageModule): void {
      const element = host.current;
      if (!isWanted || element === null) {
        return;
      }
      const stage = attempt > 0 ? kept.replacedStage() : kept.keptStage();
      if (stage === null) {
        setProblem("noWebgl");
        return;
      }
      const act = choose(kept);
      const stopListening = act.rig.listen(element);
      act.rig.onChange = () => stage.turn(performance.now());
      stage.onLost = (isLost) => setProblem(isLost ? "lost" : null);
      stage.show(act, element);
      setProblem(stage.isLost ? "lost" : null);
      setPicture({ act, stage });
      leave = () => {
        stopListening();
        act.rig.onChange = null;
        stage.onLost = null;
        stage.hide();
      };
    }

    import("../../scene/attitude/keptStage").then(enter, () => isWanted && setProblem("notLoaded"));
    return () => {
      isWanted = false;
      leave();
      setPicture(null);
    };
  }, [host, choose, attempt]);

  useEffect(() => {
    const element = host.current;
    if (picture === null || element === null) {
      return undefined;
    }
    const paint = (): void => {
      dress(picture.act, paletteOf(element));
      picture.stage.invalidate();
    };
    paint();
    const dressed = new MutationObserver(paint);
    dressed.observe(document.documentElement, { attributeFilter: ["data-theme"] });
    return () => dressed.disconnect();
  }, [picture, host, dress]);

  const retry = useCallback(() => setAttempt((before) => before + 1), []);
  return { picture, problem, retry };
}
