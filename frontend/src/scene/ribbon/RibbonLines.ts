import { BoundingSphere, Cartesian3, Cartesian4, type Color, type PictureState } from "@cesium/engine";
import type { Globe } from "../globe/Globe";
import { downToTheSea } from "./ball";
import { Ribbon, type RibbonStyle } from "./Ribbon";
import { SCALE_COLOURS } from "./shaders";
import { beginPiece, boundsOf, type Place, POINT_FLOATS, writePlace } from "./vertices";

/** Style of a line; lengths in CSS pixels. */
export interface LineLook {
  readonly colour: Color;
  readonly width_px: number;
  /** The outline, within the line's width. */
  readonly edge?: { readonly colour: Color; readonly width_px: number };
  /** Length of dash and gap; by default the line is solid. */
  readonly dash_px?: number;
}

export interface RibbonLine {
  /** The same object for all lines of this style: they are drawn together. */
  readonly look: LineLook;
  readonly places: readonly Place[];
}

/** Lines in the air that change seldom. */
export class RibbonLines {
  readonly #globe: Globe;
  /** Kept while no line has this style, so that its shaders are not compiled again. */
  readonly #drawn = new Map<LineLook, { readonly ribbon: Ribbon; readonly sphere: BoundingSphere }>();
  readonly #primitive = {
    update: (state: PictureState): void => {
      if (state.passes.render) {
        for (const { ribbon } of this.#drawn.values()) {
          ribbon.draw(state, "line");
        }
      }
    },
    isDestroyed: (): boolean => false,
    destroy: (): void => {
      for (const { ribbon } of this.#drawn.values()) {
        ribbon.destroy();
      }
      this.#drawn.clear();
    },
  };

  constructor(globe: Globe) {
    this.#globe = globe;
    globe.scene.primitives.add(this.#primitive);
  }

  /** Show exactly these lines. */
  show(lines: readonly RibbonLine[]): void {
    for (const { ribbon } of this.#drawn.values()) {
      ribbon.set(new Float32Array(0), 0);
    }
    for (const look of new Set(lines.map((line) => line.look))) {
      const vertices = verticesOf(lines.filter((line) => line.look === look));
      const count = vertices.length / POINT_FLOATS;
      const { ribbon, sphere } = this.#ribbonOf(look);
      downToTheSea(boundsOf(vertices, count), sphere);
      ribbon.set(vertices, count);
    }
    this.#globe.requestRender();
  }

  dispose(): void {
    this.#globe.scene.primitives.remove(this.#primitive);
    this.#globe.requestRender();
  }

  #ribbonOf(look: LineLook): { readonly ribbon: Ribbon; readonly sphere: BoundingSphere } {
    const known = this.#drawn.get(look);
    if (known !== undefined) {
      return known;
    }
    const sphere = new BoundingSphere();
    const drawn = { ribbon: new Ribbon(styleOf(look), sphere), sphere };
    this.#drawn.set(look, drawn);
    return drawn;
  }
}

/** No colouring by values, as for tracks. */
const byNothing = new Cartesian4();
const noColours = Array.from({ length: SCALE_COLOURS }, () => Cartesian3.ZERO);
const uncoloured = {
  u_scale: () => byNothing,
  u_unknown: () => Cartesian3.ZERO,
  u_colours: () => noColours,
};

/** The lines in one buffer, each as a piece. */
function verticesOf(lines: readonly RibbonLine[]): Float32Array {
  const vertices = new Float32Array(lines.reduce((sum, { places }) => sum + places.length, 0) * POINT_FLOATS);
  let at = 0;
  for (const { places } of lines) {
    for (const [index, place] of places.entries()) {
      writePlace(vertices, at, place);
      if (index === 0) {
        beginPiece(vertices, at);
      }
      at += 1;
    }
  }
  return vertices;
}

function styleOf({ colour, width_px, edge, dash_px = 0 }: LineLook): RibbonStyle {
  const vector = ({ red, green, blue }: Color): Cartesian3 => new Cartesian3(red, green, blue);
  const [plain, round] = [vector(colour), vector(edge?.colour ?? colour)];
  const core_px = width_px - 2 * (edge?.width_px ?? 0);
  return {
    line: {
      ...uncoloured,
      u_plain: () => plain,
      u_width: () => width_px,
      u_core: () => core_px,
      u_edge: () => round,
      u_opacity: () => colour.alpha,
      u_dash: () => dash_px,
      u_nearer: () => 1,
    },
    isDashed: dash_px > 0,
    isTranslucent: colour.alpha < 1,
    curtain: null,
  };
}
