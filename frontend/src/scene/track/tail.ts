import { BLOCK_POINTS, DEGREES_PER_UNIT, type TrackBlock } from "../../lib/track/block";
import { isInterrupted, type TrackPoints } from "../../lib/track/trackPoints";
import { type Place, POINT_FLOATS, writePlace } from "../ribbon/vertices";
import { writePoint } from "./writePoint";

/** Where the aircraft is drawn, and the time of that position by the gateway's clock (Unix seconds). */
export interface Tip extends Place {
  readonly t_s: number;
}

/** Between two requests to the gateway the line follows the drawn aircraft: two seconds at 60 Hz. */
const SHOWN = 128;
/** Positions closer in time are dropped. */
const LEAST_STEP_S = 0.05;
const LONGEST_TIP_S = 5;
/** The last point of the block before, where the line begins. */
const BEFORE = 1;
const CAPACITY = BEFORE + BLOCK_POINTS + SHOWN + 1;

/**
 * The newest part of a track with every point: the last point of the line before, the growing block, the positions
 * where the aircraft was drawn since, and the aircraft itself.
 */
export class TrackTail {
  readonly vertices = new Float32Array(CAPACITY * POINT_FLOATS);
  readonly #points: TrackPoints;
  #shown: Tip[] = [];
  #block: TrackBlock | undefined;
  #written = 0;
  #count = 0;
  #changed = 0;
  #pointsRevision = -1;
  #tip_s: number | null = null;

  constructor(points: TrackPoints) {
    this.#points = points;
  }

  get count(): number {
    return this.#count;
  }

  /** Points before this one are unchanged since the last `update`. */
  get changed(): number {
    return this.#changed;
  }

  /** Draws up to `tip`, or to the newest point without an aircraft. Returns whether the line has changed. */
  update(tip: Tip | null): boolean {
    const block = this.#points.blocks.at(-1);
    const [pointsRevision, tip_s] = [this.#points.revision, tip?.t_s ?? null];
    if (pointsRevision === this.#pointsRevision && tip_s === this.#tip_s) {
      return false;
    }
    this.#pointsRevision = pointsRevision;
    this.#tip_s = tip_s;
    if (block !== this.#block) {
      this.#begin(block);
      this.#changed = 0;
    } else {
      this.#changed = BEFORE + this.#written;
    }
    for (; block !== undefined && this.#written < block.count; this.#written += 1) {
      writePoint(this.vertices, BEFORE + this.#written, block, this.#written);
    }
    if (block !== undefined && tip !== null && follows(block, tip)) {
      this.#count = this.#follow(block, tip);
    } else {
      this.#shown = [];
      this.#count = BEFORE + this.#written;
    }
    this.#changed = Math.min(this.#changed, BEFORE + this.#written);
    return true;
  }

  #begin(block: TrackBlock | undefined): void {
    const before = this.#points.blocks.at(-2);
    this.#block = block;
    this.#written = 0;
    if (before !== undefined) {
      writePoint(this.vertices, 0, before, before.count - 1);
    } else if (block !== undefined) {
      writePoint(this.vertices, 0, block, 0);
    }
  }

  /** The points that the drawn aircraft has passed, its positions since, and itself. Returns their number. */
  #follow(block: TrackBlock, tip: Tip): number {
    let reached = this.#written;
    while (reached > 0 && (block.t_s[reached - 1] ?? 0) > tip.t_s) {
      reached -= 1;
    }
    this.#remember(block.t_s[block.count - 1] ?? 0, tip);
    let at = BEFORE + reached;
    for (const place of this.#shown) {
      writePlace(this.vertices, at, place);
      at += 1;
    }
    writePlace(this.vertices, at, tip);
    // Points that were overwritten are written again when the aircraft has passed them.
    this.#written = reached;
    return at + 1;
  }

  #remember(last_s: number, tip: Tip): void {
    this.#shown = this.#shown.filter(({ t_s }) => t_s > last_s && t_s < tip.t_s);
    const newest = this.#shown.at(-1);
    if (tip.t_s > last_s && (newest === undefined || tip.t_s - newest.t_s >= LEAST_STEP_S)) {
      this.#shown = [...this.#shown, tip].slice(-SHOWN);
    }
  }
}

/** An aircraft far from its newest point, in time or place, did not fly the straight line between them. */
function follows(block: TrackBlock, tip: Tip): boolean {
  const point = {
    t_s: Math.max(tip.t_s, block.t_s[block.count - 1] ?? 0),
    latitude_e7: tip.latitude_deg / DEGREES_PER_UNIT,
    longitude_e7: tip.longitude_deg / DEGREES_PER_UNIT,
    altitude_mm: 0,
  };
  return (
    Math.abs(tip.t_s - (block.t_s[block.count - 1] ?? 0)) < LONGEST_TIP_S &&
    !isInterrupted(block, block.count - 1, point)
  );
}
