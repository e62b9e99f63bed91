import { Tooltip as Base } from "@base-ui/react/tooltip";
import type { ReactElement } from "react";
import "./Tooltip.css";

interface Props {
  /** Empty: nothing to say, nothing opens. */
  text: string;
  /** The one element that the text is about. It must be focusable, so that the keyboard finds the text too. */
  children: ReactElement<Record<string, unknown>>;
}

/**
 * A sentence beside an element while the pointer or the focus is on it. For eyes only: whoever uses it also
 * gives the sentence to screen readers as the element's description.
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
