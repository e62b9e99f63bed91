import { AlertDialog } from "@base-ui/react/alert-dialog";
import { useRef } from "react";
import { Button } from "./Button";
import { focusNow } from "./Dialog";
import { useOpened } from "./openDialogs";
import "./Dialog.css";

interface Props {
  title: string;
  /** What happens, and what cannot be undone. */
  text: string;
  /** Sentences of their own below the text. */
  list?: readonly string[] | undefined;
  confirmLabel: string;
  cancelLabel: string;
  danger?: boolean | undefined;
  /** A second confirming choice beside the first. */
  other?: { readonly label: string; readonly onPress: () => void } | undefined;
  onConfirm: () => void;
  onCancel: () => void;
}

/** A question before something that cannot be undone. The safe answer has the focus. */
export function ConfirmDialog(props: Props) {
  const {
    title,
    text,
    list = [],
    confirmLabel,
    cancelLabel,
    danger = false,
    other,
    onConfirm,
    onCancel,
  } = props;
  const foot = useRef<HTMLElement>(null);
  useOpened(true);
  return (
    <AlertDialog.Root open onOpenChange={(open) => open || onCancel()}>
      <AlertDialog.Portal>
        <AlertDialog.Backdrop className="ui-dialog-backdrop" />
        <AlertDialog.Popup className="ui-dialog" initialFocus={() => focusNow(foot.current)}>
          <header className="ui-dialog-head">
            <AlertDialog.Title className="ui-dialog-title">{title}</AlertDialog.Title>
          </header>
          <div className="ui-dialog-body">
            <AlertDialog.Description>{text}</AlertDialog.Description>
            {list.length > 0 && (
              <ul className="ui-dialog-list">
                {list.map((sentence) => (
                  <li key={sentence}>{sentence}</li>
                ))}
              </ul>
            )}
          </div>
          <footer ref={foot} className="ui-dialog-actions">
            <Button onPress={onCancel}>{cancelLabel}</Button>
            {other !== undefined && <Button onPress={other.onPress}>{other.label}</Button>}
            <Button variant={danger ? "danger" : "primary"} onPress={onConfirm}>
              {confirmLabel}
            </Button>
          </footer>
        </AlertDialog.Popup>
      </AlertDialog.Portal>
    </AlertDialog.Root>
  );
}
