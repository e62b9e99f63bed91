import { AttitudeScene } from "./AttitudeScene";
import { SphereScene } from "./SphereScene";
import { Stage } from "./Stage";
import { webglDrawer } from "./webgl";

let kept: Stage | null = null;
let attitude: AttitudeScene | null = null;
let sphere: SphereScene | null = null;

/** The one stage of the page, made when it is first needed; null where the browser cannot draw in 3D. */
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

/** What the stage shows; kept with it, so that no shader is made twice. */
export function keptAttitude(): AttitudeScene {
  attitude ??= new AttitudeScene();
  return attitude;
}

export function keptSphere(): SphereScene {
  sphere ??= new SphereScene();
  return sphere;
}

/** Another one in its place, where the browser did not give the first one's picture back. */
export function replacedStage(): Stage | null {
  kept?.dispose();
  kept = null;
  return keptStage();
}
