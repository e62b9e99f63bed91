/** A line of another station's parameter file: a name and its value as written. */
export interface OtherLine {
  readonly name: string;
  readonly text: string;
}

/**
 * QGroundControl's `.params`: vehicle, component, name, value and type, with tabs. Mission Planner's `.param`: name and
 * value, with a comma or a space.
 */
const LINES = [
  /^\d+\t\d+\t(?<name>\S+)\t(?<text>\S+)\t\d+$/,
  /^(?<name>[A-Za-z]\w*)[ \t]*[,\s][ \t]*(?<text>[-+.\w]+)$/,
] as const;

/** All lines of such a file; null if any line is of another form, or there is none. Lines with # are remarks. */
export function readOtherParameters(text: string): readonly OtherLine[] | null {
  const lines: OtherLine[] = [];
  for (const raw of text.replace(/^\uFEFF/, "").split(/\r?\n/)) {
    const line = raw.trim();
    if (line !== "" && !line.startsWith("#")) {
      const groups = LINES.map((form) => form.exec(line)?.groups).find((found) => found !== undefined);
      if (groups === undefined) {
        return null;
      }
      lines.push({ name: groups["name"] ?? "", text: groups["text"] ?? "" });
    }
  }
  return lines.length === 0 ? null : lines;
}
