import { Cartesian3, Color, type PointPrimitive, PointPrimitiveCollection } from "@cesium/engine";
import type { Position } from "../../lib/geodesy";
import { HOME } from "../colours";
import type { Globe } from "../globe/Globe";
import { FLIGHT_RANK, PLAIN_FONT, THROUGH_GROUND_M } from "../lettering";
import { EDGE_COLOUR } from "./style";

const HOME_COLOUR = Color.fromCssColorString(HOME);

/** Home: where the aircraft started, on the ground. */
export class HomeMark {
  readonly #globe: Globe;
  readonly #dots = new PointPrimitiveCollection();
  readonly #dot: PointPrimitive;
  #shown: (Position & { readonly label: string }) | null = null;

  constructor(globe: Globe) {
    this.#globe = globe;
    globe.scene.primitives.add(this.#dots);
    this.#dot = this.#dots.add({
      show: false,
      color: HOME_COLOUR,
      pixelSize: 12,
      outlineColor: EDGE_COLOUR,
      outlineWidth: 3,
      disableDepthTestDistance: THROUGH_GROUND_M,
    });
  }

  get position(): Cartesian3 | null {
    return this.#shown === null ? null : this.#dot.position;
  }

  show(home: (Position & { readonly label: string }) | null): void {
    const isSame =
      home?.latitude_deg === this.#shown?.latitude_deg &&
      home?.longitude_deg === this.#shown?.longitude_deg &&
      home?.label === this.#shown?.label;
    if (isSame) {
      return;
    }
    this.#shown = home;
    this.#dot.show = home !== null;
    if (home !== null) {
      const position = Cartesian3.fromDegrees(home.longitude_deg, home.latitude_deg);
      this.#dot.position = position;
    }
    this.#globe.labels.show(
      this,
      home === null
        ? []
        : [
            {
              key: "home",
              position: this.#dot.position,
              text: home.label,
              font: PLAIN_FONT,
              colour: HOME,
              rank: FLIGHT_RANK - 20,
              away_px: 10,
              isSought: true,
            },
          ],
    );
    this.#globe.requestRender();
  }

  dispose(): void {
    this.#globe.scene.primitives.remove(this.#dots);
    this.#globe.labels.show(this, []);
    this.#globe.requestRender();
  }
}
