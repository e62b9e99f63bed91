import { type RefObject, useState } from "react";
import { formatDateTime } from "../../lib/moment";
import { usePage, usePart } from "../../store/hooks";
import { plotColour } from "../../ui/plotColours";
import { cut } from "./drawn";
import type { PaneHandle } from "./PlotPane";
import { csvOf, type ExportedSignal, lineText, pictureOf } from "./plotExports";
import { PLOTS } from "./plots";
import { formatAt, stretchOf } from "./plotView";
import { edgeOf } from "./useAsking";

interface SaveState {
  readonly saveCsv: () => void;
  readonly savePng: () => void;
  readonly isPngFailed: boolean;
}

/** Saves what is seen, named by the flight and its time and not by the time of looking. */
export function useSaving(
  charts: RefObject<Map<number, PaneHandle>>,
  subject: string | null,
  otherName: string | null,
): SaveState {
  const { telemetry, pump, saveFile } = usePage();
  const plots = usePart(PLOTS);
  const [isPngFailed, setPngFailed] = useState(false);

  function seen() {
    const stretch = stretchOf(plots.store.getState().view, edgeOf(plots, telemetry, pump.now_ms));
    const { starts_s } = plots.feed.store.getState();
    const panes = [...charts.current].sort(([one], [other]) => one - other).map(([, handle]) => handle);
    const from = formatAt(stretch.from_s, 100).replaceAll(":", "-");
    return { stretch, starts_s, panes, file: `${fileTime(starts_s) ?? subject ?? "epf"}_${from}` };
  }

  function saveCsv(): void {
    const { stretch, starts_s, panes, file } = seen();
    const signals = new Map<string, ExportedSignal>();
    for (const { key, drawn, isOther } of panes.flatMap(({ lines }) => lines)) {
      const flight = isOther ? (plots.store.getState().compared ?? "") : (subject ?? "");
      signals.set(key, { flight, drawn: cut(drawn, stretch.from_s, stretch.to_s) });
    }
    const text = csvOf([...signals.values()], stretch, starts_s);
    saveFile(`${file}.csv`, new Blob([text], { type: "text/csv;charset=utf-8" }));
  }

  async function savePng(): Promise<void> {
    const { stretch, starts_s, panes, file } = seen();
    const style = getComputedStyle(document.documentElement);
    const colour = (token: string): string => style.getPropertyValue(token).trim();
    const span_s = stretch.to_s - stretch.from_s;
    const when = starts_s === null ? "" : `${formatDateTime(starts_s)} · `;
    const picture = await pictureOf(
      panes.map(({ chart, lines }) => ({
        canvas: chart.canvas,
        lines: lines.map(({ drawn, isOther }, index) => ({
          text: lineText(drawn, isOther ? otherName : null),
          colour: colour(plotColour(index)),
        })),
      })),
      {
        title: `${when}${formatAt(stretch.from_s, span_s)} – ${formatAt(stretch.to_s, span_s)}`,
        ground: colour("--surface-well"),
        ink: colour("--text"),
        font: colour("--font-ui"),
        ratio: window.devicePixelRatio || 1,
      },
    );
    setPngFailed(picture === null);
    if (picture !== null) {
      saveFile(`${file}.png`, picture);
    }
  }

  return { saveCsv, savePng: () => void savePng(), isPngFailed };
}

/** Start of the flight in a file's name, UTC: "20260131T120000Z". */
function fileTime(starts_s: number | null): string | null {
  return starts_s === null
    ? null
    : new Date(starts_s * 1000).toISOString().replace(/\.\d+/, "").replaceAll(/[-:]/g, "");
}
