import { DEGREES_PER_UNIT, METRES_PER_UNIT, type TrackBlock } from "../../lib/track/block";
import { ThinnedTrack } from "../../lib/track/thinnedTrack";
import { kept, type WeightedBlock } from "../../lib/track/thinning";
import { type Colouring, colourOf, type Range, SCALES } from "../../lib/track/trackColours";
import type { TrackPoints } from "../../lib/track/trackPoints";
import { type Box, boxOf, overlaps } from "../world/geometry";
import { boxSeen, type FlatView, metresPerPixel, toScreen } from "./projection";

export interface FlatTrackLook {
  readonly plain: string;
  readonly casing: string;
  readonly colouring: Colouring;
  readonly range: Range | null;
}

interface Chosen {
  readonly level: number;
  readonly offsets: readonly number[];
}

/** Levels of detail are made for so long in one picture. */
const SLICE_MS = 4;
/** Beyond the borders by so much a line may still come in, pixels. */
const BEYOND_PX = 50;
const WIDTH_PX = 2.5;
const CASING_PX = 4.5;
/** Colours on the way from one end of the scale to the other: each is a stroke of its own. */
const SHADES = 24;

/** A track on the flat map, in the level of detail that its scale shows. */
export class FlatTrack {
  readonly #points: TrackPoints;
  readonly #thinned: ThinnedTrack;
  readonly #chosen = new WeakMap<WeightedBlock, Chosen>();
  readonly #boxes = new WeakMap<TrackBlock, Box>();
  #revision = -1;

  constructor(points: TrackPoints) {
    this.#points = points;
    this.#thinned = new ThinnedTrack(points);
  }

  /** Points have come since it was drawn. */
  get hasNews(): boolean {
    return this.#points.revision !== this.#revision;
  }

  /** All that is here has been drawn: a long track takes some pictures for it. */
  get isComplete(): boolean {
    return this.#thinned.isComplete;
  }

  draw(context: CanvasRenderingContext2D, view: FlatView, look: FlatTrackLook): void {
    this.#revision = this.#points.revision;
    const end_ms = performance.now() + SLICE_MS;
    let made = 0;
    this.#thinned.refresh(() => made++ > 0 && performance.now() > end_ms);
    const level = Math.max(0, Math.floor(Math.log2(metresPerPixel(view))) + 3);
    context.lineJoin = "round";
    context.lineCap = "round";
    const lines = this.#lines(view, level, look);
    stroke(context, lines, look.casing, CASING_PX);
    stroke(context, lines, null, WIDTH_PX);
  }

  /** Stretches of one colour each; where the flight was interrupted another one begins. */
  #lines(view: FlatView, level: number, look: FlatTrackLook): readonly Stretch[] {
    const lines: Stretch[] = [];
    const add = (block: TrackBlock, offset: number, isStart: boolean): void => {
      const point = toScreen(view, {
        latitude_deg: (block.latitude_e7[offset] ?? 0) * DEGREES_PER_UNIT,
        longitude_deg: (block.longitude_e7[offset] ?? 0) * DEGREES_PER_UNIT,
      });
      const colour = colourAt(block, offset, look);
      const last = lines.at(-1);
      if (last === undefined || isStart) {
        lines.push({ colour, xy: [point.x, point.y] });
        return;
      }
      last.xy.push(point.x, point.y);
      if (last.colour !== colour) {
        lines.push({ colour, xy: [point.x, point.y] });
      }
    };
    const seen = boxSeen(view, BEYOND_PX);
    for (const thinned of this.#thinned.blocks) {
      const { block } = thinned;
      // Of what is not seen the last point alone: the way out of it may be.
      const offsets = overlaps(this.#boxOf(block), seen)
        ? this.#offsets(thinned, level)
        : [0, block.count - 1];
      for (const offset of offsets) {
        add(block, offset, block.starts.includes(offset));
      }
    }
    const live = this.#points.blocks.at(-1);
    for (let offset = 0; live !== undefined && !live.isFull && offset < live.count; offset += 1) {
      add(live, offset, live.starts.includes(offset));
    }
    return lines;
  }

  #boxOf(block: TrackBlock): Box {
    const known = this.#boxes.get(block);
    if (known !== undefined) {
      return known;
    }
    const degrees = (units: Int32Array): number[] =>
      Array.from(units.subarray(0, block.count), (unit) => unit * DEGREES_PER_UNIT);
    const latitudes = degrees(block.latitude_e7);
    const box = boxOf(
      degrees(block.longitude_e7).map((longitude, offset) => [longitude, latitudes[offset] ?? 0]),
    );
    this.#boxes.set(block, box);
    return box;
  }

  #offsets(block: WeightedBlock, level: number): readonly number[] {
    const known = this.#chosen.get(block);
    if (known?.level === level) {
      return known.offsets;
    }
    // An eighth of a metre is finer than any map.
    const offsets = kept(block, 2 ** (level - 3));
    this.#chosen.set(block, { level, offsets });
    return offsets;
  }
}

interface Stretch {
  readonly colour: string;
  /** x and y in turn, pixels. */
  readonly xy: number[];
}

function colourAt(block: TrackBlock, offset: number, { colouring, range, plain }: FlatTrackLook): string {
  if (colouring === "none" || range === null) {
    return plain;
  }
  const value = {
    height: (block.altitude_mm[offset] ?? 0) * METRES_PER_UNIT,
    speed: block.speed_mps[offset] ?? Number.NaN,
    climb: block.climb_mps[offset] ?? Number.NaN,
  }[colouring];
  const step = (range.most - range.least) / SHADES;
  const shade = range.least + Math.round((value - range.least) / step) * step;
  return colourOf(SCALES[colouring], range, shade);
}

function stroke(
  context: CanvasRenderingContext2D,
  lines: readonly Stretch[],
  over: string | null,
  width_px: number,
): void {
  context.lineWidth = width_px;
  for (const { colour, xy } of lines) {
    context.strokeStyle = over ?? colour;
    context.beginPath();
    context.moveTo(xy[0] ?? 0, xy[1] ?? 0);
    for (let at = 2; at < xy.length; at += 2) {
      context.lineTo(xy[at] ?? 0, xy[at + 1] ?? 0);
    }
    context.stroke();
  }
}
