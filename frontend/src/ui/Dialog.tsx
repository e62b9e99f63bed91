import { Dialog as Base } from "@base-ui/react/dialog";
import { X } from "lucide-react";
import { type ReactNode, useRef, useState } from "react";
import { Notice } from "./Notice";
import { useOpened } from "./openDialogs";
import { EditScope } from "./openEdits";
import { RefusalProvider, useRefuse } from "./refusal";
import { useWords } from "./words";
import "./Dialog.css";

interface Props {
  /** Without it the dialog is open while it is rendered. */
  open?: boolean | undefined;
  title: string;
  /** Escape, the close button, or a click beside it. */
  onClose: () => void;
  /** Name of the close button, if not "close". */
  closeLabel?: string | undefined;
  /** Read after the title. */
  description?: string | undefined;
  children?: ReactNode;
  /** The buttons that close it. */
  actions?: ReactNode;
  /** A drawer stands at the left edge, as high as the window. */
  size?: "normal" | "wide" | "drawer" | undefined;
}

/** A modal dialog. The focus stays in it, and returns to where it was when it closes. */
export function Dialog(props: Props) {
  const { open = true, title, onClose, closeLabel, description, children, actions, size = "normal" } = props;
  const words = useWords();
  const popup = useRef<HTMLDivElement>(null);
  const head = useRef<HTMLElement>(null);
  const body = useRef<HTMLDivElement>(null);
  const refuse = useRefuse();
  const [refused, setRefused] = useState<string | null>(null);
  useOpened(open);

  /** Also in front: the page's last message is behind, where nobody can read it. */
  function refuseInFront(reason: string): void {
    setRefused(reason);
    refuse(reason);
  }

  return (
    <Base.Root open={open} onOpenChange={(next) => !next && onClose()}>
      <Base.Portal>
        <Base.Backdrop className="ui-dialog-backdrop" />
        <Base.Popup
          ref={popup}
          className="ui-dialog"
          data-size={size}
          onClickCapture={() => setRefused(null)}
          // A touch needs no focus: it would show an outline, or bring up the keyboard.
          initialFocus={(opened) =>
            opened === "touch" ? popup.current : focusNow(body.current, FIELD) && focusNow(head.current)
          }
        >
          <header ref={head} className="ui-dialog-head">
            <Base.Title className="ui-dialog-title">{title}</Base.Title>
            <Base.Close className="ui-dialog-close" aria-label={closeLabel ?? words.close}>
              <X size={16} aria-hidden="true" />
            </Base.Close>
          </header>
          {description !== undefined && (
            <Base.Description className="ui-dialog-description">{description}</Base.Description>
          )}
          <RefusalProvider value={refuseInFront}>
            <EditScope>
              {children !== undefined && (
                // biome-ignore lint/a11y/noNoninteractiveTabindex: what scrolls must be in reach of the keyboard
                <div ref={body} className="ui-dialog-body" tabIndex={0}>
                  {children}
                </div>
              )}
              {refused !== null && <Notice level="warning">{refused}</Notice>}
              {actions !== undefined && <footer className="ui-dialog-actions">{actions}</footer>}
            </EditScope>
          </RefusalProvider>
        </Base.Popup>
      </Base.Portal>
    </Base.Root>
  );
}

/** What words are typed into: who opened a dialog that asks for them can type at once. */
const FIELD = "input[type=text]:not([role=combobox]), textarea";

/**
 * Focus the first button in `place`, or what `wanted` selects, as a dialog's first focus. The dialog by itself would do
 * it with the next animation frame: a key that is pressed before that moves the focus of the page behind, is overtaken
 * by the late focus, and the Enter after it presses another button than the user chose. Returns what `initialFocus`
 * wants: true if nothing was found, so that the dialog chooses.
 */
export function focusNow(place: HTMLElement | null, wanted = "button"): boolean {
  const found = place?.querySelector<HTMLElement>(wanted) ?? null;
  found?.focus();
  return found === null;
}
