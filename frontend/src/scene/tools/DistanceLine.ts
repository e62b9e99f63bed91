import { Cartesian3, Color, PointPrimitiveCollection } from "@cesium/engine";
import type { Position } from "../../lib/geodesy";
import { EDGE, MEASURE } from "../colours";
import type { Globe } from "../globe/Globe";
import type { SpaceText } from "../globe/GlobeLabels";
import { legPoints } from "../legs/geometry";
import type { GroundPlace } from "../legs/target";
import { FLIGHT_RANK, PLAIN_FONT, THROUGH_GROUND_M } from "../lettering";
import { type LineLook, type RibbonLine, RibbonLines } from "../ribbon/RibbonLines";
import type { Place } from "../ribbon/vertices";

export interface MeasuredPlace extends GroundPlace {
  readonly label: string;
}

const EDGE_COLOUR = Color.fromCssColorString(EDGE);
/** Height of the line above the ground, metres: in the ground it would flicker. */
const OVER_GROUND_M = 3;

/** The distance tool's line along the ground, with the length at each corner. */
export class DistanceLine {
  readonly #globe: Globe;
  readonly #lines: RibbonLines;
  readonly #dots = new PointPrimitiveCollection();

  readonly #colour: Color;
  readonly #look: LineLook;

  constructor(globe: Globe, colour = MEASURE) {
    this.#globe = globe;
    this.#colour = Color.fromCssColorString(colour);
    this.#look = { colour: this.#colour, width_px: 3 };
    this.#lines = new RibbonLines(globe);
    globe.scene.primitives.add(this.#dots);
  }

  show(places: readonly MeasuredPlace[]): void {
    const lines: RibbonLine[] = [];
    this.#dots.removeAll();
    const texts: SpaceText[] = [];
    for (const [index, to] of places.entries()) {
      const from = places[index - 1];
      const place = overGround(to, to.height_m);
      const position = Cartesian3.fromDegrees(place.longitude_deg, place.latitude_deg, place.altitude_m);
      if (from !== undefined) {
        const way = legPoints({ ...from, altitude_ft: 0 }, { ...to, altitude_ft: 0 });
        const places = way.map((on, step) => overGround(on, step === 0 ? from.height_m : to.height_m));
        lines.push({ look: this.#look, places });
      }
      this.#dots.add({
        position,
        color: this.#colour,
        pixelSize: 8,
        outlineColor: EDGE_COLOUR,
        outlineWidth: 2,
        disableDepthTestDistance: THROUGH_GROUND_M,
      });
      texts.push({
        key: `${this.#colour.toCssHexString()} ${index}`,
        position,
        text: to.label,
        font: PLAIN_FONT,
        colour: this.#colour.toCssColorString(),
        rank: FLIGHT_RANK + 30,
        away_px: 10,
        isSought: true,
      });
    }
    this.#globe.labels.show(this, texts);
    this.#lines.show(lines);
  }

  dispose(): void {
    this.#lines.dispose();
    this.#globe.scene.primitives.remove(this.#dots);
    this.#globe.labels.show(this, []);
  }
}

function overGround({ longitude_deg, latitude_deg }: Position, height_m: number | null): Place {
  return { longitude_deg, latitude_deg, altitude_m: (height_m ?? 0) + OVER_GROUND_M };
}
