import type { ReactNode, Ref } from "react";
import { HALF_SIDE } from "./layer";

interface Props {
  ref?: Ref<HTMLDivElement>;
  /** The part of the picture that it covers, in its units from the middle; it turns about that middle. */
  box: { readonly x: number; readonly y: number; readonly width: number; readonly height: number };
  /** Half the side of the picture, in its units. */
  halfSide?: number;
  className?: string;
  children: ReactNode;
}

/**
 * A moving part of an instrument as its own layer: the browser keeps its pixels and only shifts and turns them. As
 * part of one picture it would be laid out and rastered again in each animation frame.
 */
export function Layer({ ref, box, halfSide = HALF_SIDE, className, children }: Props) {
  const percent = (units: number): string => `${(units * 50) / halfSide}%`;
  return (
    <div
      ref={ref}
      className={className === undefined ? "inst-layer" : `inst-layer ${className}`}
      style={{
        left: percent(box.x + halfSide),
        top: percent(box.y + halfSide),
        width: percent(box.width),
        height: percent(box.height),
        transformOrigin: `${(-box.x / box.width) * 100}% ${(-box.y / box.height) * 100}%`,
      }}
    >
      <svg viewBox={`${box.x} ${box.y} ${box.width} ${box.height}`} aria-hidden="true">
        {children}
      </svg>
    </div>
  );
}

/** A round hole in the middle of the picture, through which its layers are seen. */
export function RoundWindow({ radius, children }: { radius: number; children: ReactNode }) {
  const margin = HALF_SIDE - radius;
  return (
    <div className="inst-round-window inst-moving" style={{ inset: `${margin / 2}%` }}>
      <div className="inst-round-window-picture" style={{ inset: `${(-margin / radius) * 50}%` }}>
        {children}
      </div>
    </div>
  );
}
