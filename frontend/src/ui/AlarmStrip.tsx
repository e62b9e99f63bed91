import { Check, OctagonAlert, TriangleAlert } from "lucide-react";
import { type ReactNode, useId } from "react";
import "./AlarmStrip.css";
import { Tooltip } from "./Tooltip";
import { useWords } from "./words";

export interface AlarmItem {
  id: string;
  level: "warning" | "critical";
  text: string;
  /** Somebody knows of it: it stands there quietly. */
  acknowledged: boolean;
  /** What is not read out again while the alarm lasts: since when it does. */
  detail?: string | undefined;
  /** Why it cannot be acknowledged here. */
  blocked?: string | undefined;
}

/** An alarm that ended unacknowledged. */
export interface EndedItem {
  id: string;
  level: AlarmItem["level"];
  text: string;
  /** When it ended. */
  detail: string;
  /** Why it cannot be acknowledged here. */
  blocked?: string | undefined;
}

interface EndOfAlarm {
  label: string;
  items: readonly EndedItem[];
  /** Accessible name of the button that acknowledges one. */
  acknowledge: { label: (text: string) => string; onPress: (id: string) => void };
}

interface Props {
  label: string;
  /** Which time it tells of, where that is not plain. */
  when?: string | undefined;
  /** What stands in the strip while there is nothing to tell. */
  quiet: string;
  ended: EndOfAlarm;
  /** The most urgent first. */
  alarms: readonly AlarmItem[];
  /** Accessible name and text of the button that acknowledges one alarm. */
  acknowledge: { label: (text: string) => string; text: string; onPress: (id: string) => void };
  /** What can be done about all of them. */
  children?: ReactNode;
}

/** So many alarms have a place; the others are heard by screen readers and are counted. */
export const LINES = 2;
/** Most ended alarms that are shown beside the active ones. */
const CHIPS = 3;

/** Number of ended alarms that do not fit in the strip. */
export function endedWithoutPlace(alarms: number, ended: number): number {
  return alarms < LINES ? Math.max(0, ended - CHIPS) : ended;
}

/**
 * The alarms in force, in a place of one height, with or without alarms: a hand that is on its way to a button must find it
 * where it was. In a wide window two stand side by side; what a narrow one has no room for lies over the page. The two live
 * regions are always in the document: a region that appears together with its text is not read out by every reader.
 */
export function AlarmStrip({ label, when, quiet, alarms, ended, acknowledge, children }: Props) {
  const seen = alarms.slice(0, LINES);
  const hasTraces = ended.items.length > 0 && seen.length < LINES;
  const isQuiet = alarms.length + ended.items.length === 0;
  const lines = (wanted: AlarmItem["level"]): ReactNode =>
    alarms
      .filter(({ level }) => level === wanted)
      .map((alarm) => (
        <AlarmLine key={alarm.id} alarm={alarm} isSeen={seen.includes(alarm)} acknowledge={acknowledge} />
      ));
  return (
    <section className="ui-alarms" aria-label={label}>
      <div className="ui-alarms-body">
        {when !== undefined && <strong className="ui-alarms-when">{when}</strong>}
        <div className="ui-alarms-lines">
          <div role="alert" aria-atomic="false" aria-relevant="additions">
            {lines("critical")}
          </div>
          <div role="status" aria-atomic="false" aria-relevant="additions">
            {lines("warning")}
          </div>
          {hasTraces && <Traces {...ended} />}
          {isQuiet && <p className="ui-alarms-quiet">{quiet}</p>}
        </div>
        {!isQuiet && <div className="ui-alarms-actions">{children}</div>}
      </div>
    </section>
  );
}

/** Outside the live regions: the end of an alarm must not interrupt a screen reader. */
function Traces({ label, items, acknowledge }: EndOfAlarm) {
  return (
    <div className="ui-alarms-ended">
      <span className="ui-alarms-ended-label">{label}</span>
      <ul className="ui-alarms-chips">
        {items.slice(0, CHIPS).map(({ id, level, text, detail, blocked }) => (
          <li key={id} className="ui-alarms-chip" data-level={level}>
            <span className="ui-alarms-chip-text" title={text}>
              {text}
            </span>
            <span className="ui-alarm-detail">{detail}</span>
            <AcknowledgeButton
              className="ui-alarms-chip-button"
              label={acknowledge.label(text)}
              blocked={blocked}
              onPress={() => acknowledge.onPress(id)}
            />
          </li>
        ))}
      </ul>
    </div>
  );
}

interface LineProps {
  alarm: AlarmItem;
  isSeen: boolean;
  acknowledge: Props["acknowledge"];
}

function AlarmLine({ alarm, isSeen, acknowledge }: LineProps) {
  const words = useWords();
  const isCritical = alarm.level === "critical";
  const level = isCritical ? words.critical : words.warning;
  if (!isSeen) {
    return (
      <p className="visually-hidden">
        <span>{level}</span> <span>{alarm.text}</span>
      </p>
    );
  }
  return (
    <div className="ui-alarm" data-level={alarm.level} data-acknowledged={alarm.acknowledged}>
      {isCritical ? (
        <OctagonAlert size={16} aria-hidden="true" />
      ) : (
        <TriangleAlert size={16} aria-hidden="true" />
      )}
      <span className="ui-alarm-level">{level}</span>
      <span className="ui-alarm-text" title={alarm.text}>
        {alarm.text}
      </span>
      {alarm.detail !== undefined && <span className="ui-alarm-detail">{alarm.detail}</span>}
      {!alarm.acknowledged && (
        <AcknowledgeButton
          className="ui-alarm-button"
          label={acknowledge.label(alarm.text)}
          blocked={alarm.blocked}
          onPress={() => acknowledge.onPress(alarm.id)}
        >
          {acknowledge.text}
        </AcknowledgeButton>
      )}
    </div>
  );
}

interface ButtonProps {
  className: string;
  /** Accessible name. */
  label: string;
  blocked: string | undefined;
  onPress: () => void;
  children?: ReactNode;
}

function AcknowledgeButton({ className, label, blocked, onPress, children }: ButtonProps) {
  const noteId = useId();
  return (
    <>
      <Tooltip text={blocked ?? ""}>
        <button
          type="button"
          className={className}
          aria-label={label}
          aria-disabled={blocked !== undefined || undefined}
          aria-describedby={blocked === undefined ? undefined : noteId}
          onClick={() => {
            if (blocked === undefined) onPress();
          }}
        >
          <Check size={14} aria-hidden="true" />
          {children}
        </button>
      </Tooltip>
      {/* Hidden from the live region around it: it must not be read out with the alarm. */}
      <span id={noteId} className="visually-hidden" aria-hidden="true">
        {blocked}
      </span>
    </>
  );
}
