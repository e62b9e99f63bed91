import { type ReactNode, type Ref, useId } from "react";
import "./dial.css";

/** What every round instrument needs to be told. */
export interface DialProps {
  /** Accessible name. */
  label: string;
  /** Written across the red cross when there is nothing live to show. */
  noDataText: string;
}

interface FrameProps extends DialProps {
  ref: Ref<SVGSVGElement>;
  descriptionRef: Ref<SVGDescElement>;
  children: ReactNode;
  className?: string | undefined;
}

/**
 * Frame, face and red cross of a round instrument; what moves goes inside.
 *
 * `data-state` starts as `none` and is flipped by the painter alone: React renders it once and never again,
 * so no render can undo what was painted. The cross needs no colour to be seen.
 */
export function Dial({ ref, descriptionRef, label, noDataText, className, children }: FrameProps) {
  const bezel = useId();
  return (
    <div className="inst-frame">
      <svg
        ref={ref}
        className={className === undefined ? "inst-dial" : `inst-dial ${className}`}
        viewBox="-100 -100 200 200"
        role="img"
        aria-label={label}
        data-state="none"
      >
        <desc ref={descriptionRef} />
        <defs>
          <linearGradient id={bezel} x1="0.2" y1="0" x2="0.8" y2="1">
            <stop offset="0" className="inst-bezel-light" />
            <stop offset="0.45" className="inst-bezel-middle" />
            <stop offset="1" className="inst-bezel-dark" />
          </linearGradient>
        </defs>
        <circle r="99.5" className="inst-bezel-edge" />
        <circle r="98.5" fill={`url(#${bezel})`} />
        <circle r="93" className="inst-bezel-well" />
        <circle r="91.5" className="inst-face" />
        <g className="inst-live">{children}</g>
        <g className="inst-cross">
          <path d="M-60 -60L60 60M60 -60L-60 60" />
          <rect x="-58" y="-12" width="116" height="24" rx="2" />
          <text y="4.6">{noDataText}</text>
        </g>
      </svg>
    </div>
  );
}
