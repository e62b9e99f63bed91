import { useTranslation } from "react-i18next";
import { formatFlightTime } from "../../lib/moment";
import type { ReportManoeuvre } from "../../protocol/guards.gen";

const WIDTH = 300;
const HEIGHT = 130;
const LEFT = 40;
const BOTTOM = 18;
const TOP = 6;
const RIGHT = 6;

interface Props {
  readonly one: ReportManoeuvre;
}

/** Signal and target of a manoeuvre, with the marks of rise, overshoot and settling. */
export function ManoeuvrePicture({ one }: Props) {
  const { t } = useTranslation();
  const { trace } = one;
  if (trace === null || trace.at_s.length < 2) {
    return null;
  }
  const kind = t(`report.kind.${one.kind}`);
  const label = t("report.picture", { kind, at: formatFlightTime(one.at_s) });
  const every = [...trace.value, ...trace.target].filter((value) => value !== null);
  if (every.length === 0) {
    return null;
  }
  const [low, high] = [Math.min(...every), Math.max(...every)];
  const room = Math.max((high - low) * 0.08, 1e-6);
  const [first, last] = [trace.at_s[0] ?? 0, trace.at_s.at(-1) ?? 1];
  const x = (at_s: number): number => LEFT + ((at_s - first) / (last - first || 1)) * (WIDTH - LEFT - RIGHT);
  const y = (value: number): number =>
    TOP + ((high + room - value) / (high - low + 2 * room)) * (HEIGHT - TOP - BOTTOM);
  return (
    <svg className="report-picture" viewBox={`0 0 ${WIDTH} ${HEIGHT}`} role="img" aria-label={label}>
      <title>{label}</title>
      <line className="report-axis" x1={LEFT} x2={LEFT} y1={TOP} y2={HEIGHT - BOTTOM} />
      <line className="report-axis" x1={LEFT} x2={WIDTH - RIGHT} y1={HEIGHT - BOTTOM} y2={HEIGHT - BOTTOM} />
      <Label x={LEFT - 4} y={y(high) + 3} anchor="end" text={high.toFixed(high - low < 5 ? 1 : 0)} />
      <Label x={LEFT - 4} y={y(low) + 3} anchor="end" text={low.toFixed(high - low < 5 ? 1 : 0)} />
      <Label x={x(Math.max(0, first))} y={HEIGHT - 5} anchor="middle" text="0" />
      <Label x={WIDTH - RIGHT} y={HEIGHT - 5} anchor="end" text={`${last.toFixed(0)} s`} />
      <Marks one={one} x={x} y={y} />
      <path className="report-target" d={stairs(trace.at_s, trace.target, x, y)} />
      <path className="report-signal" d={line(trace.at_s, trace.value, x, y)} />
      {one.peak !== null && one.peak_s !== null && one.peak_s <= last && (
        <circle className="report-peak" cx={x(one.peak_s)} cy={y(one.peak)} r={3} />
      )}
    </svg>
  );
}

interface MarksProps extends Props {
  readonly x: (at_s: number) => number;
  readonly y: (value: number) => number;
}

/** The rise as a band, the settled time and the final value as lines. */
function Marks({ one, x, y }: MarksProps) {
  const until_s = one.until_s - one.at_s;
  return (
    <>
      {one.rise_from_s !== null && one.rise_to_s !== null && (
        <rect
          className="report-rise"
          x={x(one.rise_from_s)}
          width={Math.max(1, x(Math.min(one.rise_to_s, until_s)) - x(one.rise_from_s))}
          y={TOP}
          height={HEIGHT - TOP - BOTTOM}
        />
      )}
      {one.settling_s !== null && one.settling_s <= until_s && (
        <line
          className="report-settled"
          x1={x(one.settling_s)}
          x2={x(one.settling_s)}
          y1={TOP}
          y2={HEIGHT - BOTTOM}
        />
      )}
      {one.final !== null && (
        <line className="report-final" x1={x(0)} x2={x(until_s)} y1={y(one.final)} y2={y(one.final)} />
      )}
    </>
  );
}

function Label(props: { x: number; y: number; anchor: "end" | "middle"; text: string }) {
  const { x, y, anchor, text } = props;
  return (
    <text x={x} y={y} textAnchor={anchor} className="report-tick">
      {text}
    </text>
  );
}

type Scale = (value: number) => number;

/** A line that is broken where a value is missing. */
function line(at_s: readonly number[], values: readonly (number | null)[], x: Scale, y: Scale): string {
  let isDown = false;
  return at_s
    .map((at, index) => {
      const value = values[index] ?? null;
      const step = value === null ? "" : `${isDown ? "L" : "M"}${x(at).toFixed(1)} ${y(value).toFixed(1)}`;
      isDown = value !== null;
      return step;
    })
    .join("");
}

/** A target jumps: it is drawn as steps. */
function stairs(at_s: readonly number[], values: readonly (number | null)[], x: Scale, y: Scale): string {
  let isDown = false;
  return at_s
    .map((at, index) => {
      const value = values[index] ?? null;
      const step =
        value === null
          ? ""
          : isDown
            ? `H${x(at).toFixed(1)}V${y(value).toFixed(1)}`
            : `M${x(at).toFixed(1)} ${y(value).toFixed(1)}`;
      isDown = value !== null;
      return step;
    })
    .join("");
}
