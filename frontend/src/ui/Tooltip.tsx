import { Tooltip as Base } from "@base-ui/react/tooltip";
import type { ReactElement } from "react";
import "./Tooltip.css";

interface Props {
  /** Empty: no tooltip. */
  text: string;
  /** The element that the text describes. It must be focusable, so that keyboard users see the text too. */
  children: ReactElement<Record<string, unknown>>;
}

/**
 * A text beside an element while it is hovered or focused. Only visual: the caller also gives the text to screen
 * readers as the element's description.
 */
export function Tooltip({ text, children }: Props) {
  return (
    <Base.Root disabled={text === ""}>
      <Base.Trigger delay={250} closeOnClick={false} render={children} />
      <Base.Portal>
        <Base.Positioner sideOffset={6} className="ui-tooltip-place">
          <Base.Popup className="ui-tooltip">{text}</Base.Popup>
        </Base.Positioner>
      </Base.Portal>
    </Base.Root>
  );
}
