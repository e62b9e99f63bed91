import { Menu as Base } from "@base-ui/react/menu";
import { Menubar } from "@base-ui/react/menubar";
import { Check } from "lucide-react";
import { createContext, type ReactNode, type RefObject, useContext, useId, useState } from "react";
import { usePress } from "./refusal";
import { StateMark } from "./StateMark";
import type { CommandState } from "./words";
import { commandWord, useWords } from "./words";
import "./MenuBar.css";

/** Which way the titles of the bar stand. */
const WayContext = createContext<"horizontal" | "vertical">("horizontal");

/** The element that holds open menus: beside their bar, in its landmark, and not at the end of the page. */
const HomeContext = createContext<HTMLElement | null>(null);

interface BarProps {
  label: string;
  /** One title under the other, where a row has no room. */
  orientation?: "horizontal" | "vertical" | undefined;
  children: ReactNode;
}

/** The menu bar at the top of the window. The page behind an open menu keeps running. */
export function MenuBar({ label, orientation = "horizontal", children }: BarProps) {
  const [home, setHome] = useState<HTMLElement | null>(null);
  return (
    <WayContext value={orientation}>
      <HomeContext value={home}>
        <Menubar className="ui-menubar" aria-label={label} modal={false} orientation={orientation}>
          {children}
        </Menubar>
        <div ref={setHome} className="ui-menu-home" />
      </HomeContext>
    </WayContext>
  );
}

interface MenuProps {
  label: string;
  /** Rendered, and its stores read, only while the menu is open. */
  children: ReactNode;
}

export function Menu({ label, children }: MenuProps) {
  return (
    <Base.Root>
      <Base.Trigger className="ui-menu-title">{label}</Base.Trigger>
      <Popup>{children}</Popup>
    </Base.Root>
  );
}

interface AnchoredProps {
  /** The element that the menu is attached to, and that gets the focus back when it closes. */
  anchor: RefObject<HTMLElement | null>;
  /** Its place in the document. */
  home: RefObject<HTMLElement | null>;
  onClose: () => void;
  children: ReactNode;
}

/** A menu not opened from the menu bar. */
export function AnchoredMenu({ anchor, home, onClose, children }: AnchoredProps) {
  return (
    <Base.Root open modal={false} onOpenChange={(open) => open || onClose()}>
      <Popup anchor={anchor} home={home}>
        {children}
      </Popup>
    </Base.Root>
  );
}

function Popup({ anchor, home, children }: Partial<AnchoredProps>) {
  const barHome = useContext(HomeContext);
  // Under its title also where titles stand one under the other: beside it there is no room.
  const isVertical = useContext(WayContext) === "vertical" && anchor === undefined;
  return (
    <Base.Portal container={home ?? barHome}>
      <Base.Positioner
        className="ui-menu-place"
        positionMethod="fixed"
        sideOffset={2}
        collisionPadding={4}
        {...(isVertical ? { side: "bottom", align: "start" } : {})}
        anchor={anchor}
      >
        <Base.Popup className="ui-menu" {...(anchor === undefined ? {} : { finalFocus: anchor })}>
          {children}
        </Base.Popup>
      </Base.Positioner>
    </Base.Portal>
  );
}

/** Menu entries under a heading. */
export function MenuGroup({ label, children }: MenuProps) {
  return (
    <Base.Group className="ui-menu-group">
      <Base.GroupLabel className="ui-menu-heading">{label}</Base.GroupLabel>
      {children}
    </Base.Group>
  );
}

export function MenuRule() {
  return <Base.Separator className="ui-menu-rule" />;
}

/** Props of every entry. */
interface EntryProps {
  label: string;
  /** Why it is disabled: shown in the entry, which stays reachable and answers a press with it. */
  disabledReason?: string | undefined;
  state?: CommandState | undefined;
  stateText?: string | undefined;
  /** The keyboard shortcut. */
  aside?: string | undefined;
}

/**
 * Ids of an entry's name and note. The reason why it is disabled is part of its name; the outcome of the last click
 * is a description, so that the name does not change when the answer comes.
 */
function useEntry({ disabledReason, state = "idle", stateText }: Omit<EntryProps, "label">) {
  const words = useWords();
  const labelId = useId();
  const noteId = useId();
  const note = disabledReason ?? stateText ?? commandWord(words, state);
  return {
    note,
    labelId,
    noteId,
    press: usePress(disabledReason),
    isDisabled: disabledReason !== undefined,
    shared: {
      className: "ui-menu-item",
      // Not disabled for the menu, which would swallow the press.
      "aria-disabled": disabledReason === undefined ? undefined : true,
      "data-disabled": disabledReason === undefined ? undefined : "",
      "aria-labelledby": disabledReason === undefined ? labelId : `${labelId} ${noteId}`,
      "aria-describedby": disabledReason === undefined && note !== "" ? noteId : undefined,
    },
  };
}

interface BodyProps extends EntryProps {
  labelId: string;
  noteId: string;
  note: string;
}

function Body({ label, aside, state = "idle", note, labelId, noteId }: BodyProps) {
  return (
    <>
      <span className="ui-menu-text">
        <span id={labelId} className="ui-menu-label">
          {label}
        </span>
        {note !== "" && (
          <span id={noteId} className="ui-menu-note" data-state={state}>
            {note}
          </span>
        )}
      </span>
      {/* Drawn by the style sheet: as text it would be part of what is seen and not of the name that is heard. */}
      {aside !== undefined && <span className="ui-menu-aside" aria-hidden="true" data-key={aside} />}
      <StateMark state={state} />
    </>
  );
}

interface ActionProps extends EntryProps {
  onChoose: () => void;
  /** Whether this is the present state. */
  isCurrent?: boolean | undefined;
  danger?: boolean | undefined;
}

export function MenuAction({ onChoose, isCurrent = false, danger = false, ...entry }: ActionProps) {
  const { shared, press, isDisabled, ...ids } = useEntry(entry);
  return (
    <Base.Item
      {...shared}
      closeOnClick={!isDisabled}
      label={entry.label}
      data-danger={danger}
      aria-current={isCurrent ? "true" : undefined}
      onClick={() => press(onChoose)}
    >
      <span className="ui-menu-mark">{isCurrent && <Check size={14} aria-hidden="true" />}</span>
      <Body {...entry} {...ids} />
    </Base.Item>
  );
}

interface SwitchProps extends EntryProps {
  /** The reported state; the menu stays open, so that the change can be watched. */
  checked: boolean;
  onChange: (checked: boolean) => void;
}

export function MenuSwitch({ checked, onChange, ...entry }: SwitchProps) {
  const { shared, press, isDisabled: _, ...ids } = useEntry(entry);
  return (
    <Base.CheckboxItem
      {...shared}
      label={entry.label}
      checked={checked}
      onCheckedChange={(asked) => press(() => onChange(asked))}
    >
      <span className="ui-menu-mark ui-menu-box" data-checked={checked}>
        {checked && <Check size={12} strokeWidth={3} aria-hidden="true" />}
      </span>
      <Body {...entry} {...ids} />
    </Base.CheckboxItem>
  );
}

interface ChoiceProps<V extends string> extends EntryProps {
  options: readonly { readonly value: V; readonly label: string; readonly aside?: string }[];
  /** `null` while unknown. */
  value: V | null;
  onChange: (value: V) => void;
}

/** A choice of a few under a heading: the reported one is marked. */
export function MenuChoice<V extends string>({ options, value, onChange, ...group }: ChoiceProps<V>) {
  const { shared, press, note, noteId } = useEntry(group);
  return (
    <Base.RadioGroup
      className="ui-menu-group"
      value={value ?? ""}
      onValueChange={(next: V) => press(() => onChange(next))}
      aria-describedby={note === "" ? undefined : noteId}
    >
      <div className="ui-menu-heading">
        <Base.GroupLabel render={<span />}>{group.label}</Base.GroupLabel>
        <StateMark state={group.state ?? "idle"} />
      </div>
      {options.map((option) => (
        <Base.RadioItem
          key={option.value}
          className="ui-menu-item"
          value={option.value}
          aria-disabled={shared["aria-disabled"]}
          data-disabled={shared["data-disabled"]}
          aria-describedby={note === "" ? undefined : noteId}
        >
          <span className="ui-menu-mark ui-menu-dot" data-checked={value === option.value} />
          <span className="ui-menu-label">{option.label}</span>
          {option.aside !== undefined && <span className="ui-menu-aside">{option.aside}</span>}
        </Base.RadioItem>
      ))}
      {note !== "" && (
        <p id={noteId} className="ui-menu-note ui-menu-foot" data-state={group.state ?? "idle"}>
          {note}
        </p>
      )}
    </Base.RadioGroup>
  );
}

interface LinkProps {
  label: string;
  href: string;
  /** File name for a download; without it the address is opened in another browser tab. */
  download?: string | undefined;
  aside?: string | undefined;
}

export function MenuLink({ label, href, download, aside }: LinkProps) {
  const target = download === undefined ? { target: "_blank", rel: "noreferrer" } : { download };
  return (
    <Base.LinkItem className="ui-menu-item" href={href} {...target} closeOnClick label={label}>
      <span className="ui-menu-mark" />
      <span className="ui-menu-label">{label}</span>
      {aside !== undefined && <span className="ui-menu-aside">{aside}</span>}
    </Base.LinkItem>
  );
}
