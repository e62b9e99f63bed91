/** Stretches of a line, by the indices of their first points: from `begin` up to, excluding, `end`. */
export interface Range {
  readonly begin: number;
  readonly end: number;
}

/** Drawing up to this many invisible stretches costs less than another draw call. */
const SMALL = 200;
/** Greatest number of draw calls of one line per picture. */
const MOST = 12;

/**
 * The ranges of a line of several blocks to draw: the stretches of the visible blocks, with the stretch before and
 * the one after each. `starts`: the first point of each block; `count`: points of the line.
 */
export function rangesOf(
  starts: readonly number[],
  count: number,
  isSeen: (block: number) => boolean,
): readonly Range[] {
  const found: { begin: number; end: number }[] = [];
  for (const [block, start] of starts.entries()) {
    const begin = Math.max(0, start - 1);
    const end = Math.min(count - 1, starts[block + 1] ?? count);
    if (end <= begin || !isSeen(block)) {
      continue;
    }
    const last = found.at(-1);
    if (last !== undefined && begin - last.end <= SMALL) {
      last.end = end;
    } else {
      found.push({ begin, end });
    }
  }
  while (found.length > MOST) {
    joinNearest(found);
  }
  return found;
}

/** Joins the two closest ranges, and draws the part between them too. */
function joinNearest(ranges: { begin: number; end: number }[]): void {
  let at = 1;
  const room = (index: number): number => (ranges[index]?.begin ?? 0) - (ranges[index - 1]?.end ?? 0);
  for (let index = 2; index < ranges.length; index += 1) {
    at = room(index) < room(at) ? index : at;
  }
  const [one, other] = [ranges[at - 1], ranges[at]];
  if (one !== undefined && other !== undefined) {
    one.end = other.end;
    ranges.splice(at, 1);
  }
}
