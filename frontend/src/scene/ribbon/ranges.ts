/** Stretches of a line, each counted by the point it begins with: from `begin` up to, and not with, `end`. */
export interface Range {
  readonly begin: number;
  readonly end: number;
}

/** So few stretches that nobody sees cost less than one more drawing. */
const SMALL = 48;
/** Drawings of one line in a frame. */
const MOST = 12;

/**
 * What of a line of several blocks is to be drawn: the stretches of those that are seen, and to each of them the one
 * that leads there and the one that leads on. `starts`: the first point of each block; `count`: points of the line.
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

/** Draws what is between the two that lie closest. */
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
