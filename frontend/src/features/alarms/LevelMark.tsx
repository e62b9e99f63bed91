import { OctagonAlert, TriangleAlert } from "lucide-react";
import { useWords } from "../../ui/words";
import type { AlarmLevel } from "./raisedAlarms";

/** How bad it is, in shape, colour and word; where there is no room the word is left to screen readers. */
export function LevelMark({ level, isBrief = false }: { level: AlarmLevel; isBrief?: boolean }) {
  const words = useWords();
  const Icon = level === "critical" ? OctagonAlert : TriangleAlert;
  return (
    <span className="alarms-level" data-level={level}>
      <Icon size={16} aria-hidden="true" />
      <span className={isBrief ? "visually-hidden" : undefined}>
        {level === "critical" ? words.critical : words.warning}
      </span>
    </span>
  );
}
