import { useActiveAlarms, useEndedAlarms } from "./useAlarms";
import "./unseen.css";

/** Above this the exact number says nothing more. */
const MOST = 9;

/**
 * How many alarms nobody has acknowledged, those that came and went among them; nothing at zero. Its colour is the
 * most urgent one's. Silent for screen readers: the strip of alarms above every tab says each.
 */
export function UnseenAlarms() {
  const unseen = [...useActiveAlarms().filter(({ acknowledged }) => !acknowledged), ...useEndedAlarms()];
  if (unseen.length === 0) {
    return null;
  }
  const isCritical = unseen.some(({ level }) => level === "critical");
  return (
    <span className="alarms-unseen" data-level={isCritical ? "critical" : "warning"} aria-hidden="true">
      {unseen.length > MOST ? `${MOST}+` : unseen.length}
    </span>
  );
}
