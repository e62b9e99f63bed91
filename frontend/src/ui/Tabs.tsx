import { Tabs as Base } from "@base-ui/react/tabs";
import { type ReactNode, type RefObject, useEffect, useRef } from "react";
import "./Tabs.css";

export interface Tab<V extends string> {
  value: V;
  label: string;
  /** Over the label, where the tabs are a bar of an app. */
  icon?: ReactNode;
  /** Over the corner of the tab; of no width, so that no tab moves. */
  badge?: ReactNode;
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
  orientation?: "horizontal" | "vertical" | undefined;
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
    orientation = "horizontal",
    trailing,
  } = props;
  const first = tabs[0]?.value;
  const list = useRef<HTMLDivElement>(null);
  useOpenTabInSight(list, value, orientation);
  return (
    <Base.Root
      className={props.className === undefined ? "ui-tabs" : `ui-tabs ${props.className}`}
      data-size={size}
      orientation={orientation}
      {...(value === undefined ? { defaultValue: defaultValue ?? first } : { value })}
      onValueChange={(next: V) => onValueChange?.(next)}
    >
      <div className="ui-tabs-row">
        <Base.List ref={list} className="ui-tabs-list" aria-label={label} activateOnFocus>
          {tabs.map((tab) => (
            <Base.Tab key={tab.value} value={tab.value} className="ui-tab">
              {tab.icon}
              {tab.icon === undefined ? tab.label : <span className="ui-tab-label">{tab.label}</span>}
              {tab.badge}
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

/** Scrolls a row that is too long until the open tab is whole in sight. The page around it does not move. */
function useOpenTabInSight(
  list: RefObject<HTMLDivElement | null>,
  value: string | undefined,
  orientation: "horizontal" | "vertical",
): void {
  // biome-ignore lint/correctness/useExhaustiveDependencies: each time another tab opens, or the row is turned
  useEffect(() => {
    const row = list.current;
    const tab = row?.querySelector<HTMLElement>('[aria-selected="true"]');
    if (row && tab) {
      const [inRow, inTab] = [row.getBoundingClientRect(), tab.getBoundingClientRect()];
      row.scrollLeft += Math.min(0, inTab.left - inRow.left) + Math.max(0, inTab.right - inRow.right);
      row.scrollTop += Math.min(0, inTab.top - inRow.top) + Math.max(0, inTab.bottom - inRow.bottom);
    }
  }, [list, value, orientation]);
}
