import type { ReactNode } from "react";
import "./Toolbar.css";

interface Props {
  label: string;
  children: ReactNode;
}

/**
 * A bar of controls. It is a named group, not an ARIA toolbar: its switches use the arrow keys, which a toolbar would
 * take.
 */
export function Toolbar({ label, children }: Props) {
  return (
    // biome-ignore lint/a11y/useSemanticElements: a fieldset cannot be laid out as a bar in every browser
    <div className="ui-toolbar" role="group" aria-label={label}>
      {children}
    </div>
  );
}
