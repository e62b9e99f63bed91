import { type Ref, useImperativeHandle, useRef } from "react";
import { useTranslation } from "react-i18next";
import { formatMeasured } from "../lib/format";
import { PLOT_DASHES, plotColour } from "../ui/plotColours";
import { type Signal, signalKey } from "./signals";

export interface PlotKeyHandle {
  /** Values of the signals in their order; null is no data. */
  paint(values: ReadonlyArray<number | null>): void;
}

/** The plot's legend: each line's sample, name, and value under the pointer, or else the newest. */
export function PlotKey({ ref, signals }: { ref: Ref<PlotKeyHandle>; signals: readonly Signal[] }) {
  const { t } = useTranslation();
  const dash = t("words.dash");
  const numbers = useRef<Array<HTMLSpanElement | null>>([]);
  useImperativeHandle(
    ref,
    () => ({
      paint(values) {
        for (const [index, value] of values.entries()) {
          const element = numbers.current[index];
          const text = formatMeasured(value) ?? dash;
          if (element && element.textContent !== text) {
            element.textContent = text;
          }
        }
      },
    }),
    [dash],
  );
  return (
    <ul className="live-plot-key">
      {signals.map((signal, index) => (
        <li key={signalKey(signal)}>
          <svg className="live-plot-line" viewBox="0 0 28 8" aria-hidden="true">
            <path
              d="M0 4H28"
              style={{ stroke: `var(${plotColour(index)})` }}
              strokeDasharray={(PLOT_DASHES[index % PLOT_DASHES.length] ?? []).join(" ")}
            />
          </svg>
          <span>{signal.label}</span>
          <span
            ref={(element) => {
              numbers.current[index] = element;
            }}
            className="live-plot-number"
          />
          {signal.unit !== undefined && <span className="live-plot-unit">{signal.unit}</span>}
        </li>
      ))}
    </ul>
  );
}
