import { AttitudeScene } from "./AttitudeScene";
import { SphereScene } from "./SphereScene";
import { Stage } from "./Stage";
import { webglDrawer } from "./webgl";

let kept: Stage | null = null;
let attitude: AttitudeScene | null = null;
let sphere: SphereScene | null = null;

/** The page's one stage, made on first use; null if the browser has no WebGL. */
export function keptStage(): Stage | null {
  if (kept === null) {
    const drawer = webglDrawer();
    if (drawer !== null) {
      kept = new Stage(drawer, {
        request: (callback) => requestAnimationFrame(callback),
        cancel: (handle) => cancelAnimationFrame(handle),
      });
    }
  }
  return kept;
}

/** The stage's act; kept with it, so that no shader is compiled twice. */
export function keptAttitude(): AttitudeScene {
  attitude ??= new AttitudeScene();
  return attitude;
}

export function keptSphere(): SphereScene {
  sphere ??= new SphereScene();
  return sphere;
}

/** A new stage, if the browser did not restore the first one's context. */
export function replacedStage(): Stage | null {
  kept?.dispose();
  kept = null;
  return keptStage();
}
