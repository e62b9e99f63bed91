import { OctagonAlert, TriangleAlert } from "lucide-react";
import { useWords } from "../../ui/words";
import type { AlarmLevel } from "./raisedAlarms";

/** An alarm's level by shape, colour and word; in narrow places the word is only for screen readers. */
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
