import type { ReactNode } from "react";
import "./Toolbar.css";

interface Props {
  label: string;
  children: ReactNode;
}

/**
 * A bar of controls. It is a named group and not an ARIA toolbar: the switches in it own the arrow keys, and a
 * toolbar would take them away.
 */
export function Toolbar({ label, children }: Props) {
  return (
    // biome-ignore lint/a11y/useSemanticElements: a fieldset cannot be laid out as a bar in every browser
    <div className="ui-toolbar" role="group" aria-label={label}>
      {children}
    </div>
  );
}

/** Controls of a toolbar that belong together, under a name that is shown. */
export function ToolbarGroup({ label, children }: Props) {
  return (
    // biome-ignore lint/a11y/useSemanticElements: as above
    <div className="ui-toolbar-group" role="group" aria-label={label}>
      <span className="ui-toolbar-label" aria-hidden="true">
        {label}
      </span>
      {children}
    </div>
  );
}
