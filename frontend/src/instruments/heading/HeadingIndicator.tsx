import { type Ref, useImperativeHandle, useMemo, useRef } from "react";
import { DESCRIPTION_PERIOD_MS, Pace } from "../../lib/pace";
import { Dial, type DialProps } from "../dial/Dial";
import { Layer } from "../dial/Layer";
import { layerTransform, setTransform } from "../dial/layer";
import { removeAttribute, setAttribute, setText } from "../dial/paint";
import { isDrawable } from "../dial/scale";
import {
  attributeBearing,
  bugTurn_deg,
  type Cardinals,
  cardNumerals,
  cardTurn_deg,
  REFERENCE_MARKS,
  TICKS_FIVE,
  TICKS_TEN,
} from "./geometry";
import "./heading.css";

export interface HeadingHandle {
  /** Show heading [deg] and, where there is one, the bug's bearing [deg]; `null` heading shows the cross. */
  paint(heading_deg: number | null, bearing_deg: number | null, now_ms?: number): void;
}

interface Props extends DialProps {
  ref?: Ref<HeadingHandle>;
  cardinals: Cardinals;
  /** One sentence for screen readers; the bearing is `null` where there is no bug. */
  describe?: ((heading_deg: number, bearing_deg: number | null) => string) | undefined;
}

const CARD_BOX = { x: -83, y: -83, width: 166, height: 166 };
const BUG_BOX = { x: -11, y: -92, width: 22, height: 11 };

/** Heading indicator: the card turns under a fixed lubber line, the bug rides on the card. */
export function HeadingIndicator({ ref, label, noDataText, cardinals, describe }: Props) {
  const root = useRef<HTMLDivElement>(null);
  const description = useRef<HTMLSpanElement>(null);
  const card = useRef<HTMLDivElement>(null);
  const bug = useRef<HTMLDivElement>(null);
  const numerals = useMemo(() => cardNumerals(cardinals), [cardinals]);

  useImperativeHandle(ref, () => {
    const pace = new Pace(DESCRIPTION_PERIOD_MS);

    function paintBug(heading_deg: number, bearing_deg: number | null): void {
      if (!isDrawable(bearing_deg)) {
        setAttribute(bug.current, "hidden", "");
        removeAttribute(root.current, "data-bearing-deg");
        return;
      }
      setTransform(bug.current, layerTransform(bugTurn_deg(heading_deg, bearing_deg)));
      setAttribute(root.current, "data-bearing-deg", attributeBearing(bearing_deg));
      removeAttribute(bug.current, "hidden");
    }

    return {
      paint(heading_deg, bearing_deg, now_ms = performance.now()) {
        if (!isDrawable(heading_deg)) {
          setAttribute(root.current, "data-state", "none");
          removeAttribute(root.current, "data-heading-deg");
          removeAttribute(root.current, "data-bearing-deg");
          setText(description.current, noDataText);
          pace.reset();
          return;
        }
        setTransform(card.current, layerTransform(cardTurn_deg(heading_deg)));
        paintBug(heading_deg, bearing_deg);
        setAttribute(root.current, "data-heading-deg", attributeBearing(heading_deg));
        setAttribute(root.current, "data-state", "live");
        if (describe !== undefined && pace.due(now_ms)) {
          setText(description.current, describe(heading_deg, isDrawable(bearing_deg) ? bearing_deg : null));
        }
      },
    };
  }, [describe, noDataText]);

  const over = (
    <>
      {REFERENCE_MARKS.map(({ angle_deg }) => (
        <path
          key={angle_deg}
          d="M0 -84.5L2.8 -91H-2.8Z"
          transform={`rotate(${angle_deg})`}
          className="inst-mark"
        />
      ))}
      <path d="M0 -74L4.6 -91.2H-4.6Z" className="inst-lubber" />
      <path
        d="M0 -34C2.6 -34 3.6 -29 3.6 -24V-11L34 1V7L3.6 2.5V21L13 27V31L0 28L-13 31V27L-3.6 21V2.5L-34 7V1L-3.6 -11V-24C-3.6 -29 -2.6 -34 0 -34Z"
        className="inst-moving inst-airframe"
      />
    </>
  );
  return (
    <Dial ref={root} descriptionRef={description} label={label} noDataText={noDataText} over={over}>
      <Layer ref={card} box={CARD_BOX} className="inst-card inst-moving">
        <path d={TICKS_FIVE} className="inst-tick" />
        <path d={TICKS_TEN} className="inst-tick inst-tick-middle" />
        {numerals.map(({ text, angle_deg, cardinal }) => (
          <text
            key={angle_deg}
            y="-61"
            transform={`rotate(${angle_deg})`}
            className={cardinal ? "inst-numeral inst-cardinal" : "inst-numeral"}
          >
            {text}
          </text>
        ))}
      </Layer>
      <Layer ref={bug} box={BUG_BOX} className="inst-bug-layer inst-moving">
        <path d="M-10 -91.2H10V-82.5H5.5L0 -87L-5.5 -82.5H-10Z" className="inst-bug" />
      </Layer>
    </Dial>
  );
}
