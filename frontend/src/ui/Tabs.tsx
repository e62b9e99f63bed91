import { Tabs as Base } from "@base-ui/react/tabs";
import type { ReactNode } from "react";
import "./Tabs.css";

export interface Tab<V extends string> {
  value: V;
  label: string;
  content: ReactNode;
}

interface Props<V extends string> {
  /** Accessible name of the row of tabs. */
  label: string;
  tabs: readonly Tab<V>[];
  /** The open tab; without it the tabs keep their own state. */
  value?: V | undefined;
  defaultValue?: V | undefined;
  onValueChange?: ((value: V) => void) | undefined;
  /** Keep closed tabs mounted, if their content is expensive to build. */
  keepMounted?: boolean | undefined;
  size?: "main" | "sub" | undefined;
  /** Shown at the right end of the row. */
  trailing?: ReactNode;
  className?: string | undefined;
}

/** Tabs: arrow keys move along the row and open the tab at once. */
export function Tabs<V extends string>(props: Props<V>) {
  const {
    label,
    tabs,
    value,
    defaultValue,
    onValueChange,
    keepMounted = false,
    size = "sub",
    trailing,
  } = props;
  const first = tabs[0]?.value;
  return (
    <Base.Root
      className={props.className === undefined ? "ui-tabs" : `ui-tabs ${props.className}`}
      data-size={size}
      {...(value === undefined ? { defaultValue: defaultValue ?? first } : { value })}
      onValueChange={(next: V) => onValueChange?.(next)}
    >
      <div className="ui-tabs-row">
        <Base.List className="ui-tabs-list" aria-label={label} activateOnFocus>
          {tabs.map((tab) => (
            <Base.Tab key={tab.value} value={tab.value} className="ui-tab">
              {tab.label}
            </Base.Tab>
          ))}
        </Base.List>
        {trailing}
      </div>
      {tabs.map((tab) => (
        <Base.Panel key={tab.value} value={tab.value} keepMounted={keepMounted} className="ui-tabs-panel">
          {tab.content}
        </Base.Panel>
      ))}
    </Base.Root>
  );
}
