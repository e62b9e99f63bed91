import { type ReactNode, useId } from "react";
import "./Panel.css";

interface Props {
  title: string;
  /** What a title that is a term of the board means: shown at the pointer. */
  hint?: string | undefined;
  level?: 2 | 3 | undefined;
  /** State of the stream behind the panel: a StreamBadge. */
  badge?: ReactNode;
  /** Buttons of the whole panel. */
  actions?: ReactNode;
  className?: string | undefined;
  /** A group instead of a landmark, for a panel with the same title as another. */
  plain?: boolean | undefined;
  children: ReactNode;
}

/** A titled group of readings or controls, like a placard of an instrument panel. */
export function Panel(props: Props) {
  const { title, hint, level = 2, badge, actions, className, plain = false, children } = props;
  const heading = useId();
  const Heading = level === 2 ? "h2" : "h3";
  const Root = plain ? "div" : "section";
  return (
    <Root
      role={plain ? "group" : undefined}
      className={className === undefined ? "ui-panel" : `ui-panel ${className}`}
      aria-labelledby={heading}
    >
      <header className="ui-panel-head">
        <Heading id={heading} className="ui-panel-title" title={hint}>
          {title}
        </Heading>
        <span className="ui-panel-rule" aria-hidden="true" />
        {badge}
        {actions !== undefined && <div className="ui-panel-actions">{actions}</div>}
      </header>
      <div className="ui-panel-body">{children}</div>
    </Root>
  );
}
