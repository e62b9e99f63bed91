import { OctagonAlert, TriangleAlert } from "lucide-react";
import type { AlarmLevel } from "../../store/alarms";
import { useWords } from "../../ui/words";

/** How bad it is, in shape, colour and word. */
export function LevelMark({ level }: { level: AlarmLevel }) {
  const words = useWords();
  const Icon = level === "critical" ? OctagonAlert : TriangleAlert;
  return (
    <span className="alarms-level" data-level={level}>
      <Icon size={16} aria-hidden="true" />
      {level === "critical" ? words.critical : words.warning}
    </span>
  );
}
