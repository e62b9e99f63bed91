import { useRef, useState } from "react";
import { useTranslation } from "react-i18next";
import { useSentence } from "../../i18n/useSentence";
import { formatFlightTime } from "../../lib/moment";
import { usePart } from "../../store/hooks";
import type { Message } from "../../store/messages";
import { Button } from "../../ui/Button";
import { Dialog } from "../../ui/Dialog";
import { Notice } from "../../ui/Notice";
import { TextField } from "../../ui/TextField";
import { PLAYBACK } from "./playbackRequests";

/** As many letters as the gateway takes. */
const MOST_LETTERS = 500;

/**
 * Asks for the words of a mark at the moment that is shown; in the present, at the moment the key was pressed. Who has
 * no hand free presses Enter: the words can come later.
 */
export function MarkDialog({ onClose }: { readonly onClose: () => void }) {
  const { t } = useTranslation();
  const sentence = useSentence();
  const playback = usePart(PLAYBACK);
  const [shown] = useState(() => playback.store.getState());
  const [pressed_ms] = useState(() => performance.now());
  const [text, setText] = useState("");
  const [failure, setFailure] = useState<Message | null>(null);
  const isSending = useRef(false);
  const words = text.trim().slice(0, MOST_LETTERS);

  async function set(): Promise<void> {
    if (isSending.current) {
      return;
    }
    isSending.current = true;
    const refused = await playback.mark(
      words === "" ? t("time.mark") : words,
      (performance.now() - pressed_ms) / 1000,
    );
    isSending.current = false;
    if (refused === null) {
      onClose();
    } else {
      setFailure(refused);
    }
  }

  return (
    <Dialog
      title={
        shown.flight === null
          ? t("time.markTitleNow")
          : t("time.markTitle", { time: formatFlightTime(shown.at_s, 1) })
      }
      onClose={onClose}
      actions={
        <>
          <Button onPress={onClose}>{t("time.markCancel")}</Button>
          <Button variant="primary" onPress={() => void set()}>
            {t("time.markSet")}
          </Button>
        </>
      }
    >
      <TextField
        label={t("time.markText")}
        value={text}
        onCommit={setText}
        onEdit={setText}
        onEnter={() => void set()}
      />
      <p className="time-none">{t("time.markLater")}</p>
      {failure !== null && <Notice level="error">{sentence(failure)}</Notice>}
    </Dialog>
  );
}
