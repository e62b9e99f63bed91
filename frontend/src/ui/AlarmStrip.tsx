import { OctagonAlert, TriangleAlert } from "lucide-react";
import "./AlarmStrip.css";
import { useWords } from "./words";

export interface AlarmItem {
  id: string;
  level: "warning" | "critical";
  text: string;
  /** What changes while the alarm lasts, its age for one; not read out again. */
  detail?: string | undefined;
}

/**
 * The alarms in force, critical ones first. The two live regions are always in the document: a region that
 * appears together with its text is not read out by every screen reader.
 */
export function AlarmStrip({ label, alarms }: { label: string; alarms: readonly AlarmItem[] }) {
  return (
    <section className="ui-alarms" aria-label={label}>
      <div role="alert" aria-atomic="false" aria-relevant="additions">
        {alarms.filter(isCritical).map((alarm) => (
          <AlarmLine key={alarm.id} alarm={alarm} />
        ))}
      </div>
      <div role="status" aria-atomic="false" aria-relevant="additions">
        {alarms
          .filter((alarm) => !isCritical(alarm))
          .map((alarm) => (
            <AlarmLine key={alarm.id} alarm={alarm} />
          ))}
      </div>
    </section>
  );
}

function isCritical(alarm: AlarmItem): boolean {
  return alarm.level === "critical";
}

function AlarmLine({ alarm }: { alarm: AlarmItem }) {
  const words = useWords();
  const critical = isCritical(alarm);
  return (
    <div className="ui-alarm" data-level={alarm.level}>
      {critical ? (
        <OctagonAlert size={16} aria-hidden="true" />
      ) : (
        <TriangleAlert size={16} aria-hidden="true" />
      )}
      <span className="ui-alarm-level">{critical ? words.critical : words.warning}</span>
      <span className="ui-alarm-text">{alarm.text}</span>
      {alarm.detail !== undefined && <span className="ui-alarm-detail">{alarm.detail}</span>}
    </div>
  );
}
