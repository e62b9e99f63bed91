/** A place on the screen, CSS pixels from the top left. */
export interface Spot {
  readonly x: number;
  readonly y: number;
}

export interface LabelBox {
  readonly left: number;
  readonly top: number;
  readonly right: number;
  readonly bottom: number;
}

/** A label that wants to be shown beside its place. */
export interface WantedLabel {
  /** The same from picture to picture. */
  readonly key: string;
  /** Of two labels in each other's way the one of the higher rank stays. */
  readonly rank: number;
  readonly at: Spot;
  readonly width: number;
  readonly height: number;
  /** Distance between the place and the label. */
  readonly away_px: number;
  /** It looks for room farther away too: for what must be read. */
  readonly isSought: boolean;
}

export interface PlacedLabel {
  /** Which of the sides it stands on: kept from picture to picture. */
  readonly side: number;
  readonly box: LabelBox;
}

/** A label that was shown keeps its place against one that is this much higher in rank: nothing flickers. */
export const KEPT_RANK = 6;
/** Room between two labels. */
const GAP_PX = 2;
const RING_SIDES = 8;
const RINGS = 5;
const GRID_PX = 96;
const EVERYWHERE: LabelBox = { left: -Infinity, top: -Infinity, right: Infinity, bottom: Infinity };

/**
 * Place labels so that no two boxes meet: the highest ranks first, each on the first of its sides that is free; one
 * without a free side is left out. `before` is where each was in the last picture; `taken` is left free. No label reaches
 * over the edge of `within`: what is left of "27°55′N" there is another latitude.
 */
export function placeLabels(
  wanted: readonly WantedLabel[],
  before: ReadonlyMap<string, PlacedLabel>,
  taken: readonly LabelBox[] = [],
  within: LabelBox = EVERYWHERE,
): Map<string, PlacedLabel> {
  const ground = new OccupiedBoxes();
  for (const box of taken) {
    ground.take(box);
  }
  const rankOf = ({ key, rank }: WantedLabel): number => rank + (before.has(key) ? KEPT_RANK : 0);
  const ordered = [...wanted].sort(
    (one, other) => rankOf(other) - rankOf(one) || (one.key < other.key ? -1 : one.key > other.key ? 1 : 0),
  );
  const placed = new Map<string, PlacedLabel>();
  for (const label of ordered) {
    const last = before.get(label.key)?.side ?? null;
    const found = placed.has(label.key) ? null : freeSide(label, last, ground, within);
    if (found !== null) {
      placed.set(label.key, found);
      ground.take(found.box);
    }
  }
  return placed;
}

function freeSide(
  label: WantedLabel,
  last: number | null,
  ground: OccupiedBoxes,
  within: LabelBox,
): PlacedLabel | null {
  const sides = sidesOf(label);
  const order = last === null ? sides.keys() : [last, ...sides.keys()];
  for (const side of order) {
    const box = sides[side];
    if (box !== undefined && isInside(box, within) && ground.isFree(box)) {
      return { side, box };
    }
  }
  return null;
}

/** Right, right above, right below, left, left above, left below, above, below; then in rings farther away. */
export function sidesOf({ at, width, height, away_px, isSought }: WantedLabel): readonly LabelBox[] {
  const box = (left: number, top: number): LabelBox => ({
    left,
    top,
    right: left + width,
    bottom: top + height,
  });
  const [right, left] = [at.x + away_px, at.x - away_px - width];
  const [above, below] = [at.y - away_px / 2 - height, at.y + away_px / 2];
  const [across, middle] = [at.y - height / 2, at.x - width / 2];
  const sides = [
    box(right, above),
    box(right, across),
    box(right, below),
    box(left, above),
    box(left, across),
    box(left, below),
    box(middle, at.y - away_px - height),
    box(middle, at.y + away_px),
  ];
  for (let ring = 1; isSought && ring <= RINGS; ring += 1) {
    for (let step = 0; step < RING_SIDES; step += 1) {
      const angle = (2 * Math.PI * (step + 0.5)) / RING_SIDES;
      const reach_x = away_px + width / 2 + ring * height;
      const reach_y = away_px + ring * 1.6 * height;
      sides.push(box(middle + Math.cos(angle) * reach_x, across - Math.sin(angle) * reach_y));
    }
  }
  return sides;
}

function isInside(box: LabelBox, within: LabelBox): boolean {
  return (
    box.left >= within.left &&
    box.top >= within.top &&
    box.right <= within.right &&
    box.bottom <= within.bottom
  );
}

/** Whether two boxes are nearer to each other than the gap. */
export function meets(one: LabelBox, other: LabelBox, gap_px = 0): boolean {
  return (
    one.left < other.right + gap_px &&
    other.left < one.right + gap_px &&
    one.top < other.bottom + gap_px &&
    other.top < one.bottom + gap_px
  );
}

/** The boxes that are taken, found by the squares of a grid that they touch. */
class OccupiedBoxes {
  readonly #squares = new Map<string, LabelBox[]>();

  take(box: LabelBox): void {
    for (const square of squaresOf(box)) {
      const there = this.#squares.get(square);
      if (there === undefined) {
        this.#squares.set(square, [box]);
      } else {
        there.push(box);
      }
    }
  }

  isFree(box: LabelBox): boolean {
    for (const square of squaresOf(box)) {
      for (const taken of this.#squares.get(square) ?? []) {
        if (meets(box, taken, GAP_PX)) {
          return false;
        }
      }
    }
    return true;
  }
}

function* squaresOf({ left, top, right, bottom }: LabelBox): Generator<string> {
  const last_x = Math.floor((right + GAP_PX) / GRID_PX);
  const last_y = Math.floor((bottom + GAP_PX) / GRID_PX);
  for (let x = Math.floor((left - GAP_PX) / GRID_PX); x <= last_x; x += 1) {
    for (let y = Math.floor((top - GAP_PX) / GRID_PX); y <= last_y; y += 1) {
      yield `${x},${y}`;
    }
  }
}
