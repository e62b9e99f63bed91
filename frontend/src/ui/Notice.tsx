import { CircleAlert, Info, TriangleAlert, X } from "lucide-react";
import type { ReactNode } from "react";
import "./Notice.css";
import { useWords } from "./words";

interface Props {
  level: "info" | "warning" | "error";
  children: ReactNode;
  onDismiss?: (() => void) | undefined;
}

const ICONS = { info: Info, warning: TriangleAlert, error: CircleAlert } as const;

/** A sentence beside what it is about: why something failed, and what to do. */
export function Notice({ level, children, onDismiss }: Props) {
  const words = useWords();
  const Icon = ICONS[level];
  return (
    <div className="ui-notice" data-level={level} role={level === "error" ? "alert" : "status"}>
      <Icon size={16} aria-hidden="true" className="ui-notice-icon" />
      <div className="ui-notice-text">{children}</div>
      {onDismiss !== undefined && (
        <button type="button" className="ui-notice-close" aria-label={words.dismiss} onClick={onDismiss}>
          <X size={14} aria-hidden="true" />
        </button>
      )}
    </div>
  );
}
