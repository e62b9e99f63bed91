import {
  Cartesian2,
  Cartesian3,
  Color,
  LabelCollection,
  Material,
  PointPrimitiveCollection,
  PolylineCollection,
} from "@cesium/engine";
import { EDGE, MEASURE } from "../colours";
import type { Globe } from "../globe/Globe";
import { LETTERING, THROUGH_GROUND_M } from "../lettering";
import { legPoints } from "../plan/geometry";
import type { GroundPlace } from "./MapPointer";

export interface MeasuredPlace extends GroundPlace {
  readonly label: string;
}

const COLOUR = Color.fromCssColorString(MEASURE);
const EDGE_COLOUR = Color.fromCssColorString(EDGE);
/** So far over the ground the line is drawn, metres: in it, it would flicker. */
const OVER_GROUND_M = 3;
const OFFSET = new Cartesian2(10, -12);

/** The line of the distance tool along the ground, with its length at each corner. */
export class DistanceLine {
  readonly #globe: Globe;
  readonly #lines = new PolylineCollection();
  readonly #dots = new PointPrimitiveCollection();
  readonly #labels = new LabelCollection();

  constructor(globe: Globe) {
    this.#globe = globe;
    for (const part of [this.#lines, this.#dots, this.#labels]) {
      globe.scene.primitives.add(part);
    }
  }

  show(places: readonly MeasuredPlace[]): void {
    this.#lines.removeAll();
    this.#dots.removeAll();
    this.#labels.removeAll();
    for (const [index, to] of places.entries()) {
      const from = places[index - 1];
      const position = inSpace(to.longitude_deg, to.latitude_deg, to.height_m);
      if (from !== undefined) {
        const way = legPoints({ ...from, altitude_ft: 0 }, { ...to, altitude_ft: 0 });
        this.#lines.add({
          positions: way.map((place, step) =>
            inSpace(place.longitude_deg, place.latitude_deg, step === 0 ? from.height_m : to.height_m),
          ),
          width: 3,
          material: Material.fromType(Material.ColorType, { color: COLOUR }),
        });
      }
      this.#dots.add({
        position,
        color: COLOUR,
        pixelSize: 8,
        outlineColor: EDGE_COLOUR,
        outlineWidth: 2,
        disableDepthTestDistance: THROUGH_GROUND_M,
      });
      this.#labels.add({
        ...LETTERING,
        position,
        text: to.label,
        fillColor: COLOUR,
        pixelOffset: OFFSET,
      });
    }
    this.#globe.requestRender();
  }

  dispose(): void {
    for (const part of [this.#lines, this.#dots, this.#labels]) {
      this.#globe.scene.primitives.remove(part);
    }
    this.#globe.requestRender();
  }
}

function inSpace(longitude_deg: number, latitude_deg: number, height_m: number | null): Cartesian3 {
  return Cartesian3.fromDegrees(longitude_deg, latitude_deg, (height_m ?? 0) + OVER_GROUND_M);
}
