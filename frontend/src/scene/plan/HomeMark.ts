import {
  Cartesian2,
  Cartesian3,
  Color,
  type Label,
  LabelCollection,
  type PointPrimitive,
  PointPrimitiveCollection,
} from "@cesium/engine";
import type { Position } from "../../lib/geodesy";
import { HOME } from "../colours";
import type { Globe } from "../globe/Globe";
import { LETTERING, THROUGH_GROUND_M } from "../lettering";
import { EDGE_COLOUR } from "./style";

const HOME_COLOUR = Color.fromCssColorString(HOME);

/** Home: where the aircraft started, on the ground. */
export class HomeMark {
  readonly #globe: Globe;
  readonly #dots = new PointPrimitiveCollection();
  readonly #labels = new LabelCollection();
  readonly #dot: PointPrimitive;
  readonly #label: Label;
  #shown: (Position & { readonly label: string }) | null = null;

  constructor(globe: Globe) {
    this.#globe = globe;
    globe.scene.primitives.add(this.#dots);
    globe.scene.primitives.add(this.#labels);
    this.#dot = this.#dots.add({
      show: false,
      color: HOME_COLOUR,
      pixelSize: 12,
      outlineColor: EDGE_COLOUR,
      outlineWidth: 3,
      disableDepthTestDistance: THROUGH_GROUND_M,
    });
    this.#label = this.#labels.add({
      ...LETTERING,
      position: Cartesian3.ZERO,
      show: false,
      fillColor: HOME_COLOUR,
      pixelOffset: new Cartesian2(10, 16),
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
    this.#label.show = home !== null;
    if (home !== null) {
      const position = Cartesian3.fromDegrees(home.longitude_deg, home.latitude_deg);
      this.#dot.position = position;
      this.#label.position = position;
      this.#label.text = home.label;
    }
    this.#globe.requestRender();
  }

  dispose(): void {
    this.#globe.scene.primitives.remove(this.#dots);
    this.#globe.scene.primitives.remove(this.#labels);
    this.#globe.requestRender();
  }
}
