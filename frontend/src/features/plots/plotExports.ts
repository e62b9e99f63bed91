import type { PlotSeries } from "./drawn";
import type { Stretch } from "./plotView";
import { shownName, signalLabel, unitSymbol } from "./signalNames";

/** A signal in a file; `flight` is the one it is of. */
export interface ExportedSignal {
  readonly flight: string;
  readonly drawn: PlotSeries;
}

/**
 * What is seen, as a table: a row for each time, with the least and the greatest value where a step holds more than
 * one sample. Times are seconds since the flight's start, and of the first flight also UTC.
 */
export function csvOf(
  signals: readonly ExportedSignal[],
  { from_s, to_s }: Stretch,
  starts_s: number | null,
): string {
  const rows = new Map<number, string[]>();
  const heads: string[] = ["time_utc", "at_s"];
  for (const { flight, drawn } of signals) {
    const isThinned = drawn.low.some((value, index) => value !== drawn.high[index]);
    const name = `${flight} ${shownName(drawn.name)} [${drawn.unit}]`;
    const columns = isThinned
      ? [[`${name} min`, drawn.low] as const, [`${name} max`, drawn.high] as const]
      : [[name, drawn.low] as const];
    for (const [head, values] of columns) {
      const column = heads.push(head) - 1;
      for (const [index, at_s] of drawn.at_s.entries()) {
        const value = values[index] ?? null;
        if (value !== null && at_s >= from_s && at_s <= to_s) {
          const row = rows.get(at_s) ?? [];
          row[column] = String(value);
          rows.set(at_s, row);
        }
      }
    }
  }
  const lines = [...rows]
    .sort(([one], [other]) => one - other)
    .map(([at_s, row]) => {
      const time = starts_s === null ? "" : new Date((starts_s + at_s) * 1000).toISOString();
      return [time, at_s.toFixed(6), ...heads.slice(2).map((_, index) => row[index + 2] ?? "")].join(",");
    });
  return [heads.map(quoted).join(","), ...lines, ""].join("\r\n");
}

function quoted(text: string): string {
  return /[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}

/** A plot in the picture: its canvas, and the names of its lines with their colours. */
export interface PicturedPane {
  readonly canvas: HTMLCanvasElement;
  readonly lines: ReadonlyArray<{ readonly text: string; readonly colour: string }>;
}

export function lineText({ name, unit }: PlotSeries, flight: string | null): string {
  const symbol = unitSymbol(unit);
  const plain = symbol === "" ? signalLabel(name) : `${signalLabel(name)} (${symbol})`;
  return flight === null ? plain : `${flight}: ${plain}`;
}

interface Paper {
  readonly title: string;
  readonly ground: string;
  readonly ink: string;
  readonly font: string;
  readonly ratio: number;
}

const HEAD_PX = 22;

/** The plots below each other, with what they show: null if the browser makes no picture. */
export function pictureOf(panes: readonly PicturedPane[], paper: Paper): Promise<Blob | null> {
  const { ratio } = paper;
  const head = HEAD_PX * ratio;
  const sheet = document.createElement("canvas");
  sheet.width = Math.max(1, ...panes.map(({ canvas }) => canvas.width));
  sheet.height = head + panes.reduce((sum, { canvas }) => sum + head + canvas.height, 0);
  const context = sheet.getContext("2d");
  if (context === null) {
    return Promise.resolve(null);
  }
  context.fillStyle = paper.ground;
  context.fillRect(0, 0, sheet.width, sheet.height);
  context.textBaseline = "middle";
  context.font = `${13 * ratio}px ${paper.font}`;
  context.fillStyle = paper.ink;
  context.fillText(paper.title, 8 * ratio, head / 2);
  let top = head;
  for (const { canvas, lines } of panes) {
    let x = 8 * ratio;
    for (const { text, colour } of lines) {
      context.fillStyle = colour;
      context.fillRect(x, top + head / 2 - ratio, 16 * ratio, 2 * ratio);
      context.fillText(text, x + 22 * ratio, top + head / 2);
      x += context.measureText(text).width + 44 * ratio;
    }
    context.drawImage(canvas, 0, top + head);
    top += head + canvas.height;
  }
  return new Promise((resolve) => sheet.toBlob(resolve, "image/png"));
}
