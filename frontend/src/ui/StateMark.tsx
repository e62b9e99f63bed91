import { Check, CircleAlert, Clock, LoaderCircle, Send } from "lucide-react";
import type { CommandState } from "./words";
import "./StateMark.css";

const ICONS = {
  pending: LoaderCircle,
  confirmed: Check,
  rejected: CircleAlert,
  timed_out: Clock,
  sent: Send,
} as const;

/** The mark of a command's state; its words are shown elsewhere. It keeps its place, so that nothing beside it moves. */
export function StateMark({ state }: { state: CommandState }) {
  const Icon = state === "idle" ? null : ICONS[state];
  return (
    <span className="ui-mark" data-state={state} aria-hidden="true">
      {Icon !== null && <Icon size={14} strokeWidth={2.25} />}
    </span>
  );
}
