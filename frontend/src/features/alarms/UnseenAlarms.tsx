import { usePage } from "../../store/hooks";
import { useActiveAlarms, useEndedAlarms } from "./useAlarms";
import "./unseen.css";

/** Above this the exact number says nothing more. */
const MOST = 9;

/**
 * How many alarms nobody has acknowledged, those that came and went among them; nothing at zero. Its colour is the
 * most urgent one's. Silent for screen readers: the strip of alarms above every tab says each.
 */
export function UnseenAlarms() {
  const { past } = usePage();
  const unseen = [...useActiveAlarms().filter(({ acknowledged }) => !acknowledged), ...useEndedAlarms()];
  // In the past there is nothing to acknowledge, and the present's have their strip.
  if (past !== null || unseen.length === 0) {
    return null;
  }
  const isCritical = unseen.some(({ level }) => level === "critical");
  return (
    // Drawn by the style sheet: the tab's own text stays its name.
    <span
      className="alarms-unseen"
      data-level={isCritical ? "critical" : "warning"}
      data-count={unseen.length > MOST ? `${MOST}+` : unseen.length}
      aria-hidden="true"
    />
  );
}
