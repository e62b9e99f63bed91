import {
  Cartesian2,
  Cartesian3,
  type Color,
  HorizontalOrigin,
  LabelCollection,
  PointPrimitiveCollection,
  PolylineCollection,
  VerticalOrigin,
} from "@cesium/engine";
import { METRES_PER_FOOT } from "../../lib/units";
import type { Globe } from "../globe/Globe";
import { LETTERING, STRONG_FONT, THROUGH_GROUND_M } from "../lettering";
import { type Dot, type DrawnPlan, dotsOf, linesOf } from "./shape";
import {
  ACTIVE_COLOUR,
  EDGE_COLOUR,
  type MakeMaterial,
  materialsOf,
  PLAN_COLOUR,
  type PlanKind,
  UNSENT_COLOUR,
} from "./style";

const LABEL = {
  ...LETTERING,
  horizontalOrigin: HorizontalOrigin.LEFT,
  verticalOrigin: VerticalOrigin.BOTTOM,
  pixelOffset: new Cartesian2(10, -10),
};

/** One flight plan on the globe. Drawn anew when it changes, and only then. */
export class PlanLayer {
  readonly #globe: Globe;
  readonly #colour: Color;
  readonly #materialOf: MakeMaterial;
  readonly #lines = new PolylineCollection();
  readonly #dots = new PointPrimitiveCollection();
  readonly #labels = new LabelCollection();
  #plan: DrawnPlan | null = null;

  constructor(globe: Globe, kind: PlanKind) {
    this.#globe = globe;
    this.#colour = PLAN_COLOUR[kind];
    this.#materialOf = materialsOf(kind);
    const { primitives } = globe.scene;
    primitives.add(this.#lines);
    primitives.add(this.#dots);
    primitives.add(this.#labels);
  }

  get plan(): DrawnPlan | null {
    return this.#plan;
  }

  /** Show this plan; null: none. */
  show(plan: DrawnPlan | null): void {
    if (plan === this.#plan) {
      return;
    }
    this.#plan = plan;
    this.#lines.removeAll();
    this.#dots.removeAll();
    this.#labels.removeAll();
    for (const { kind, width, points } of plan === null ? [] : linesOf(plan)) {
      this.#lines.add({
        positions: points.map(([longitude, latitude, altitude_m]) =>
          Cartesian3.fromDegrees(longitude, latitude, altitude_m),
        ),
        width,
        material: this.#materialOf(kind),
      });
    }
    for (const dot of plan === null ? [] : dotsOf(plan)) {
      this.#mark(dot);
    }
    this.#globe.requestRender();
  }

  dispose(): void {
    const { primitives } = this.#globe.scene;
    for (const part of [this.#lines, this.#dots, this.#labels]) {
      primitives.remove(part);
    }
    this.#globe.requestRender();
  }

  #mark({ at, label, isActive, isSelected, isUnsent }: Dot): void {
    const position = Cartesian3.fromDegrees(
      at.longitude_deg,
      at.latitude_deg,
      at.altitude_ft * METRES_PER_FOOT,
    );
    const isStrong = isActive || isSelected;
    const colour = isUnsent ? UNSENT_COLOUR : this.#colour;
    this.#dots.add({
      position,
      // Hollow: not on the board.
      color: isActive ? ACTIVE_COLOUR : isUnsent ? EDGE_COLOUR : colour,
      pixelSize: isStrong ? 13 : 10,
      outlineColor: isSelected ? ACTIVE_COLOUR : isActive || isUnsent ? colour : EDGE_COLOUR,
      outlineWidth: isStrong || isUnsent ? 3 : 1.5,
      disableDepthTestDistance: THROUGH_GROUND_M,
    });
    this.#labels.add({
      ...LABEL,
      position,
      text: label,
      font: isStrong ? STRONG_FONT : LETTERING.font,
      fillColor: isStrong && !isUnsent ? ACTIVE_COLOUR : colour,
    });
  }
}
