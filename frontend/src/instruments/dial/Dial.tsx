import { type ReactNode, type Ref, useId } from "react";
import "./dial.css";

/** Props of every round instrument. */
export interface DialProps {
  /** Accessible name. */
  label: string;
  /** Written across the red cross when there is nothing live to show. */
  noDataText: string;
}

interface HousingProps {
  ref: Ref<HTMLDivElement>;
  descriptionRef: Ref<HTMLSpanElement>;
  label: string;
  children: ReactNode;
}

/**
 * The housing of an instrument: name, sentence for screen readers, and the square in which its pictures and layers
 * overlap. `data-state` starts as `none` and is changed only by the painter: React renders it once, so no render can
 * undo what was painted.
 */
export function InstrumentHousing({ ref, descriptionRef, label, children }: HousingProps) {
  const description = useId();
  return (
    <div
      ref={ref}
      className="inst-housing"
      role="img"
      aria-label={label}
      aria-describedby={description}
      data-state="none"
    >
      <span ref={descriptionRef} id={description} className="inst-description" hidden />
      <div className="inst-square">{children}</div>
    </div>
  );
}

interface RoundProps extends DialProps {
  ref: Ref<HTMLDivElement>;
  descriptionRef: Ref<HTMLSpanElement>;
  /** The parts that do not move, under and over the layers. */
  face?: ReactNode;
  over?: ReactNode;
  /** The moving parts: layers. */
  children: ReactNode;
}

/** Housing, face and red cross of a round instrument. The cross is recognised without colour. */
export function Dial({ ref, descriptionRef, label, noDataText, face, over, children }: RoundProps) {
  const bezel = useId();
  return (
    <InstrumentHousing ref={ref} descriptionRef={descriptionRef} label={label}>
      <svg className="inst-picture" viewBox="-100 -100 200 200" aria-hidden="true">
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
        {face}
      </svg>
      {children}
      <svg className="inst-picture" viewBox="-100 -100 200 200" aria-hidden="true">
        {over}
        <g className="inst-cross">
          <path d="M-60 -60L60 60M60 -60L-60 60" />
          <rect x="-58" y="-12" width="116" height="24" rx="2" />
          <text y="4.6">{noDataText}</text>
        </g>
      </svg>
    </InstrumentHousing>
  );
}
