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
}

/** A tab with what it opens. */
export interface TabWithPanel<V extends string> extends Tab<V> {
  content: ReactNode;
  /** Accessible name of its panel where the tab's own says too little. */
  panelLabel?: string;
  /** A further press on the open tab opens a menu. */
  hasMenu?: boolean;
}

interface Props<V extends string> {
  /** Accessible name of the row of tabs. */
  label: string;
  tabs: readonly TabWithPanel<V>[];
  /** The open tab; without it the tabs keep their own state. */
  value?: V | undefined;
  defaultValue?: V | undefined;
  onValueChange?: ((value: V) => void) | undefined;
  /** The open tab was pressed once more; `tab` is its element. */
  onPressAgain?: ((value: V, tab: HTMLElement) => void) | undefined;
  /** Keep closed tabs mounted, if their content is expensive to build. */
  keepMounted?: boolean | undefined;
  size?: "main" | "sub" | undefined;
  orientation?: "horizontal" | "vertical" | undefined;
  /** Shown behind the tabs of the row. */
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
    onPressAgain,
  } = props;
  const first = tabs[0]?.value;
  const list = useRef<HTMLDivElement>(null);
  useOpenTabInSight(list, value, orientation);
  // A press opens its tab before it is a click: which one was open is read when it begins.
  const openBefore = useRef<V | undefined>(undefined);
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
            <Base.Tab
              key={tab.value}
              value={tab.value}
              className="ui-tab"
              aria-haspopup={tab.hasMenu === true ? "menu" : undefined}
              onPointerDown={() => {
                openBefore.current = value;
              }}
              onClick={(event) => {
                if ((openBefore.current ?? value) === tab.value) {
                  onPressAgain?.(tab.value, event.currentTarget);
                }
                openBefore.current = undefined;
              }}
            >
              <TabFace tab={tab} />
            </Base.Tab>
          ))}
        </Base.List>
        {trailing}
      </div>
      {tabs.map((tab) => (
        <Base.Panel
          key={tab.value}
          value={tab.value}
          keepMounted={keepMounted}
          className="ui-tabs-panel"
          {...(tab.panelLabel === undefined
            ? {}
            : { "aria-label": tab.panelLabel, "aria-labelledby": undefined })}
        >
          {tab.content}
        </Base.Panel>
      ))}
    </Base.Root>
  );
}

function TabFace({ tab }: { readonly tab: Tab<string> }) {
  return (
    <>
      {tab.icon}
      {tab.icon === undefined ? tab.label : <span className="ui-tab-label">{tab.label}</span>}
      {tab.badge}
    </>
  );
}

interface RowProps<V extends string> {
  /** Accessible name. */
  label: string;
  tabs: readonly Tab<V>[];
  value: V;
  onValueChange: (value: V) => void;
}

/** A row of tabs whose panel stands elsewhere. */
export function TabRow<V extends string>({ label, tabs, value, onValueChange }: RowProps<V>) {
  return (
    <Base.Root value={value} onValueChange={(next: V) => onValueChange(next)} className="ui-tab-row">
      <Base.List className="ui-tabs-list" aria-label={label} activateOnFocus>
        {tabs.map((tab) => (
          <Base.Tab key={tab.value} value={tab.value} className="ui-tab">
            <TabFace tab={tab} />
          </Base.Tab>
        ))}
      </Base.List>
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
