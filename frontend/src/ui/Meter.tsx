import { type Ref, useImperativeHandle, useRef } from "react";
import "./Meter.css";
import { SteadyText, type SteadyTextHandle } from "./SteadyText";

export interface MeterHandle {
  /**
   * Show a load in percent and its text; `null` is unknown. Over 100 the bar is full and marked, and the text shows
   * the number.
   */
  paint(percent: number | null, text: string): void;
}

interface Props {
  ref?: Ref<MeterHandle>;
  label: string;
}

/** Over its capacity a channel loses frames; near it, warn. */
function level(percent: number | null): "unknown" | "normal" | "high" | "over" {
  if (percent === null) return "unknown";
  if (percent > 100) return "over";
  return percent > 85 ? "high" : "normal";
}

/** The load of a channel: a small bar and its number. */
export function Meter({ ref, label }: Props) {
  const root = useRef<HTMLSpanElement>(null);
  const fill = useRef<HTMLSpanElement>(null);
  const number = useRef<SteadyTextHandle>(null);

  useImperativeHandle(
    ref,
    () => ({
      paint(percent, text) {
        if (root.current === null || fill.current === null || number.current === null) return;
        const known = percent !== null && Number.isFinite(percent) ? percent : null;
        const share = Math.min(1, Math.max(0, (known ?? 0) / 100));
        fill.current.style.transform = `scaleX(${share.toFixed(3)})`;
        root.current.dataset["level"] = level(known);
        number.current.write(text);
      },
    }),
    [],
  );

  return (
    <span ref={root} className="ui-meter" data-level="unknown">
      <span className="ui-meter-label">{label}</span>
      <span className="ui-meter-track" aria-hidden="true">
        <span ref={fill} className="ui-meter-fill" />
      </span>
      <SteadyText ref={number} chars={5} className="ui-meter-number" />
    </span>
  );
}
