import { Cartesian3, type Color, PointPrimitiveCollection } from "@cesium/engine";
import type { Aircraft } from "../../lib/aircraft";
import { METRES_PER_FOOT } from "../../lib/units";
import type { Globe } from "../globe/Globe";
import type { SpaceText } from "../globe/GlobeLabels";
import { type Dot, type DrawnPlan, dotsOf, linesOf } from "../legs/shape";
import { FLIGHT_RANK, PLAIN_FONT, STRONG_FONT, THROUGH_GROUND_M } from "../lettering";
import { RibbonLines } from "../ribbon/RibbonLines";
import { ACTIVE_COLOUR, EDGE_COLOUR, looksOf, PLAN_COLOUR, UNSENT_COLOUR } from "./style";

/** One flight plan on the globe. Rebuilt only when it changes. */
export class PlanLayer {
  readonly #globe: Globe;
  readonly #colour: Color;
  readonly #looks: ReturnType<typeof looksOf>;
  readonly #lines: RibbonLines;
  readonly #dots = new PointPrimitiveCollection();
  readonly #kind: Aircraft;
  #plan: DrawnPlan | null = null;

  constructor(globe: Globe, kind: Aircraft) {
    this.#globe = globe;
    this.#kind = kind;
    this.#colour = PLAN_COLOUR[kind];
    this.#looks = looksOf(kind);
    this.#lines = new RibbonLines(globe);
    const { primitives } = globe.scene;
    primitives.add(this.#dots);
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
    const lines = plan === null ? [] : linesOf(plan);
    this.#lines.show(lines.map(({ kind, places }) => ({ look: this.#looks[kind], places })));
    const dots = plan === null ? [] : dotsOf(plan);
    this.#globe.labels.show(
      this,
      dots.map((dot, index) => this.#mark(dot, index)),
    );
  }

  dispose(): void {
    const { primitives } = this.#globe.scene;
    this.#lines.dispose();
    primitives.remove(this.#dots);
    this.#globe.labels.show(this, []);
    this.#globe.requestRender();
  }

  #mark(dot: Dot, index: number): SpaceText {
    const { at, label, isActive, isSelected, isUnsent } = dot;
    const position = Cartesian3.fromDegrees(
      at.longitude_deg,
      at.latitude_deg,
      at.altitude_ft * METRES_PER_FOOT,
    );
    const isStrong = isActive || isSelected;
    const colour = isUnsent ? UNSENT_COLOUR : this.#colour;
    this.#dots.add({ position, ...dotLook(dot, colour), disableDepthTestDistance: THROUGH_GROUND_M });
    return {
      key: `${this.#kind} ${index}`,
      position,
      text: label,
      font: isStrong ? STRONG_FONT : PLAIN_FONT,
      colour: (isStrong && !isUnsent ? ACTIVE_COLOUR : colour).toCssColorString(),
      rank: FLIGHT_RANK + (isStrong ? 20 : 0),
      away_px: 10,
      isSought: true,
    };
  }
}

function dotLook({ isActive, isSelected, isUnsent }: Dot, colour: Color) {
  const isStrong = isActive || isSelected;
  return {
    // Hollow: the board does not have it.
    color: isActive ? ACTIVE_COLOUR : isUnsent ? EDGE_COLOUR : colour,
    pixelSize: isStrong ? 13 : 10,
    outlineColor: isSelected ? ACTIVE_COLOUR : isActive || isUnsent ? colour : EDGE_COLOUR,
    outlineWidth: isStrong || isUnsent ? 3 : 1.5,
  };
}
