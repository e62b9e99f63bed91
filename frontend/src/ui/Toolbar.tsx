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
