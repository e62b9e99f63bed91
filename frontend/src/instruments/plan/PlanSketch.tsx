import { type Ref, useImperativeHandle, useMemo, useRef } from "react";
import type { Position } from "../../lib/geodesy";
import { captureRadius_m, type Waypoint } from "../../lib/plan";
import { project, projectionAround, scaleBar } from "./geometry";
import "./plan.css";

export interface PlanSketchHandle {
  /** Draw the aircraft here; null: it is not live. `heading_deg` is clockwise from north, null if unknown. */
  paintAircraft(place: Position | null, heading_deg: number | null): void;
}

interface Props {
  ref?: Ref<PlanSketchHandle>;
  /** Accessible name: what it shows, in words. */
  label: string;
  waypoints: readonly Waypoint[];
  /** Index of the waypoint that is flown to; null if unknown. */
  active: number | null;
  selected: number | null;
  onSelect: (index: number) => void;
  /** The aircraft's position when the picture was last fitted; the picture includes it. */
  aircraft: Position | null;
  north: string;
  /** A length in the reader's unit. */
  formatLength: (length_m: number) => string;
}

const PICTURE = { width: 400, height: 400, rim: 34 };

/** A small picture of a plan: points, legs, capture circles, the aircraft; north up, with a scale. */
export function PlanSketch(props: Props) {
  const { ref, label, waypoints, active, selected, onSelect, aircraft, north, formatLength } = props;
  const mark = useRef<SVGGElement>(null);
  const projection = useMemo(
    () => projectionAround(aircraft === null ? waypoints : [...waypoints, aircraft], PICTURE),
    [waypoints, aircraft],
  );

  useImperativeHandle(ref, () => ({
    paintAircraft(place, heading_deg) {
      const element = mark.current;
      if (element === null) return;
      const isDrawn = place !== null && projection !== null;
      element.dataset["state"] = isDrawn ? "live" : "none";
      if (isDrawn) {
        const { x, y } = project(projection, place);
        element.setAttribute("transform", `translate(${x} ${y}) rotate(${heading_deg ?? 0})`);
        element.dataset["heading"] = heading_deg === null ? "none" : "known";
      }
    },
  }));

  if (projection === null) {
    return <div className="plan-sketch" />;
  }
  const points = waypoints.map((waypoint, index) => ({
    index,
    radius: captureRadius_m(waypoint.speed_kt) * projection.units_per_m,
    ...project(projection, waypoint),
  }));
  const bar = scaleBar(projection);
  return (
    <svg
      className="plan-sketch"
      viewBox={`0 0 ${PICTURE.width} ${PICTURE.height}`}
      role="img"
      aria-label={label}
    >
      {points.map(({ index, x, y, radius }) => (
        <circle key={index} className="plan-sketch-capture" cx={x} cy={y} r={radius} />
      ))}
      {points.slice(1).map(({ index, x, y }) => (
        <line
          key={index}
          className="plan-sketch-leg"
          data-active={active === index}
          x1={points[index - 1]?.x}
          y1={points[index - 1]?.y}
          x2={x}
          y2={y}
        />
      ))}
      {points.map(({ index, x, y }) => (
        <g
          key={index}
          className="plan-sketch-point"
          data-active={active === index}
          data-selected={selected === index}
          transform={`translate(${x} ${y})`}
          onPointerDown={() => onSelect(index)}
        >
          <circle className="plan-sketch-hit" r={14} />
          <circle className="plan-sketch-dot" r={4.5} />
          <text x={8} y={-7}>
            {index + 1}
          </text>
        </g>
      ))}
      <g ref={mark} className="plan-sketch-aircraft" data-state="none">
        <path d="M0 -11 L8 9 L0 4 L-8 9 Z" />
      </g>
      <g className="plan-sketch-scale" transform={`translate(14 ${PICTURE.height - 14})`}>
        <path d={`M0 -5 V0 H${bar.units} V-5`} />
        <text x={bar.units / 2} y={-7} textAnchor="middle">
          {formatLength(bar.length_m)}
        </text>
      </g>
      <g className="plan-sketch-north" transform={`translate(${PICTURE.width - 20} 24)`}>
        <path d="M0 -14 L5 2 L0 -2 L-5 2 Z" />
        <text y={15} textAnchor="middle">
          {north}
        </text>
      </g>
    </svg>
  );
}
