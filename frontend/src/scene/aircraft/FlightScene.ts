import type { Globe } from "../globe/Globe";
import { AircraftLayer } from "./AircraftLayer";
import { CameraRig } from "./CameraRig";

/** The aircraft, and the camera that goes with them: in each frame first where they are, then where they are seen from. */
export class FlightScene {
  readonly aircraft: AircraftLayer;
  readonly camera: CameraRig;

  constructor(globe: Globe) {
    this.aircraft = new AircraftLayer(globe);
    this.camera = new CameraRig(globe, this.aircraft);
  }

  dispose(): void {
    this.camera.dispose();
    this.aircraft.dispose();
  }
}
