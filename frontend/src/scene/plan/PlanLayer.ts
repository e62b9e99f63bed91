import {
  Cartesian2,
  Cartesian3,
  type Color,
  HorizontalOrigin,
  LabelCollection,
  PointPrimitiveCollection,
  VerticalOrigin,
} from "@cesium/engine";
import type { Aircraft } from "../../lib/aircraft";
import { METRES_PER_FOOT } from "../../lib/units";
import type { Globe } from "../globe/Globe";
import { LETTERING, STRONG_FONT, THROUGH_GROUND_M } from "../lettering";
import { RibbonLines } from "../ribbon/RibbonLines";
import { type Dot, type DrawnPlan, dotsOf, linesOf } from "./shape";
import { ACTIVE_COLOUR, EDGE_COLOUR, looksOf, PLAN_COLOUR, UNSENT_COLOUR } from "./style";

const LABEL = {
  ...LETTERING,
  horizontalOrigin: HorizontalOrigin.LEFT,
  verticalOrigin: VerticalOrigin.BOTTOM,
  pixelOffset: new Cartesian2(10, -10),
};

/** One flight plan on the globe. Rebuilt only when it changes. */
export class PlanLayer {
  readonly #globe: Globe;
  readonly #colour: Color;
  readonly #looks: ReturnType<typeof looksOf>;
  readonly #lines: RibbonLines;
  readonly #dots = new PointPrimitiveCollection();
  readonly #labels = new LabelCollection();
  #plan: DrawnPlan | null = null;

  constructor(globe: Globe, kind: Aircraft) {
    this.#globe = globe;
    this.#colour = PLAN_COLOUR[kind];
    this.#looks = looksOf(kind);
    this.#lines = new RibbonLines(globe);
    const { primitives } = globe.scene;
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
    this.#dots.removeAll();
    this.#labels.removeAll();
    const lines = plan === null ? [] : linesOf(plan);
    this.#lines.show(lines.map(({ kind, places }) => ({ look: this.#looks[kind], places })));
    for (const dot of plan === null ? [] : dotsOf(plan)) {
      this.#mark(dot);
    }
  }

  dispose(): void {
    const { primitives } = this.#globe.scene;
    this.#lines.dispose();
    primitives.remove(this.#dots);
    primitives.remove(this.#labels);
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
      // Hollow: the board does not have it.
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
