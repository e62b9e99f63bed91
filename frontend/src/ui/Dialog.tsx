import { Dialog as Base } from "@base-ui/react/dialog";
import { X } from "lucide-react";
import type { ReactNode } from "react";
import { useWords } from "./words";
import "./Dialog.css";

interface Props {
  open: boolean;
  /** Escape, the cross, or a press beside it. */
  onClose: () => void;
  title: string;
  /** Said after the title: what it is about. */
  description?: string | undefined;
  children: ReactNode;
  /** The buttons that end it. */
  actions?: ReactNode;
  size?: "normal" | "wide" | undefined;
}

/** A window over the page, which waits for an answer; the focus stays in it and goes back when it closes. */
export function Dialog({ open, onClose, title, description, children, actions, size = "normal" }: Props) {
  const words = useWords();
  return (
    <Base.Root open={open} onOpenChange={(next) => !next && onClose()}>
      <Base.Portal>
        <Base.Backdrop className="ui-dialog-backdrop" />
        <Base.Popup className="ui-dialog" data-size={size}>
          <header className="ui-dialog-head">
            <Base.Title className="ui-dialog-title">{title}</Base.Title>
            <Base.Close className="ui-dialog-close" aria-label={words.close}>
              <X size={16} aria-hidden="true" />
            </Base.Close>
          </header>
          {description !== undefined && (
            <Base.Description className="ui-dialog-description">{description}</Base.Description>
          )}
          <div className="ui-dialog-body">{children}</div>
          {actions !== undefined && <footer className="ui-dialog-actions">{actions}</footer>}
        </Base.Popup>
      </Base.Portal>
    </Base.Root>
  );
}
