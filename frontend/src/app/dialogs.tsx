import { type ReactNode, useEffect, useMemo, useRef, useState } from "react";
import { useTranslation } from "react-i18next";
import { FIELD_WISH } from "../store/fieldWish";
import { useConnection, usePart } from "../store/hooks";
import { Button } from "../ui/Button";
import { ConfirmDialog } from "../ui/ConfirmDialog";
import { Dialog } from "../ui/Dialog";
import { type LazyPart, lazyPart } from "../ui/lazyPart";
import { Notice } from "../ui/Notice";
import { type DialogName, DialogsContext, type Question, useDialogs } from "./views/useDialogs";
import { loadViews } from "./views/views";

/** Each dialog is loaded on first use. */
export const DIALOGS = {
  about: lazyPart(async () => (await import("../features/about/AboutDialog")).AboutContent),
  guide: lazyPart(async () => (await import("../features/guide/GuideContent")).GuideContent),
  checklist: lazyPart(async () => (await import("../features/checklist/ChecklistContent")).ChecklistContent),
  field: lazyPart(async () => (await import("../features/field/FieldContent")).FieldContent),
  log: lazyPart(async () => (await import("../features/log/LogContent")).LogContent),
  settings: lazyPart(async () => (await import("./settings/SettingsDialog")).SettingsContent),
  tablet: lazyPart(async () => (await import("../features/access/TabletContent")).TabletContent),
  drawer: lazyPart(async () => (await import("./compact/Drawer")).Drawer),
  signal: lazyPart(async () => (await import("./SignalContent")).SignalContent),
  shortcuts: lazyPart(async () => (await import("./shortcuts/ShortcutsDialog")).ShortcutsContent),
} as const satisfies Readonly<Record<DialogName, LazyPart>>;

/** What a new station has to know. */
export const FIRST_START_PAGE = lazyPart(
  async () => (await import("./firstStart/FirstStartPage")).FirstStartPage,
);

const SIZES: Readonly<Partial<Record<DialogName, "normal" | "drawer">>> = {
  settings: "normal",
  signal: "normal",
  drawer: "drawer",
};

/** Holds the one dialog that may be open. */
export function DialogsProvider({ children }: { children: ReactNode }) {
  const [name, setName] = useState<DialogName | null>(null);
  const [question, setQuestion] = useState<Question | null>(null);
  const dialogs = useMemo(() => ({ open: setName, close: () => setName(null), ask: setQuestion }), []);
  return (
    <DialogsContext value={dialogs}>
      {children}
      {name !== null && <Window name={name} onClose={() => setName(null)} />}
      {question !== null && <Asked question={question} onClose={() => setQuestion(null)} />}
    </DialogsContext>
  );
}

function Window({ name, onClose }: { name: DialogName; onClose: () => void }) {
  const { t } = useTranslation();
  const { Part } = DIALOGS[name];
  return (
    <Dialog title={t(`dialog.${name}`)} open onClose={onClose} size={SIZES[name] ?? "wide"}>
      <Part waiting={t("window.loading")} failed={NotLoaded} />
    </Dialog>
  );
}

function NotLoaded(retry: () => void): ReactNode {
  return <LoadFailure onRetry={retry} />;
}

/** Shown in place of a part of the page that could not be fetched. Fetched again when a lost station is back. */
export function LoadFailure({ onRetry }: { onRetry: () => void }) {
  const { t } = useTranslation();
  const isHere = useConnection(({ phase }) => phase === "open");
  const wasAway = useRef(false);
  useEffect(() => {
    if (isHere && wasAway.current) {
      onRetry();
    }
    wasAway.current = !isHere;
  }, [isHere, onRetry]);
  return (
    <Notice level="error">
      <p>{t("window.notLoaded")}</p>
      <Button onPress={onRetry}>{t("window.tryAgain")}</Button>
    </Notice>
  );
}

function Asked({ question, onClose }: { question: Question; onClose: () => void }) {
  const { t } = useTranslation();
  return (
    <ConfirmDialog
      title={question.title}
      text={question.text}
      confirmLabel={question.confirm}
      cancelLabel={t("dialog.cancel")}
      danger={question.danger}
      onConfirm={() => {
        onClose();
        question.onConfirm();
      }}
      onCancel={onClose}
    />
  );
}

/** Load every part in advance: tabs and dialogs must still open after the network is lost. */
export async function loadParts(): Promise<void> {
  await loadViews();
  for (const { load } of [...Object.values(DIALOGS), FIRST_START_PAGE]) {
    await load();
  }
}

/** Opens the window of fields when the map asks for it. */
export function FieldWished() {
  const wishes = usePart(FIELD_WISH);
  const { open } = useDialogs();
  useEffect(() => wishes.subscribe(({ wish }) => wish !== null && open("field")), [wishes, open]);
  return null;
}
