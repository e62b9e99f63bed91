import type { Globe } from "../globe/Globe";
import { AircraftLayer } from "./AircraftLayer";
import { CameraRig } from "./CameraRig";

/** The aircraft and the camera that follows them: for each picture, first the aircraft are moved, then the camera. */
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
