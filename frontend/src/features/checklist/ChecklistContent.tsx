import { Pencil, Printer, RotateCcw } from "lucide-react";
import { useEffect, useState } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useSentence } from "../../i18n/useSentence";
import { useIsPast, usePart } from "../../store/hooks";
import { Button } from "../../ui/Button";
import { Checkbox } from "../../ui/Checkbox";
import { Notice } from "../../ui/Notice";
import { ChecklistEditor } from "./ChecklistEditor";
import { CHECKLIST } from "./checklist";
import { type Item, useItems } from "./useItems";
import "./checklist.css";

/** How often the page looks for what the station sees. */
const LOOK_MS = 500;

/** The list to be gone through before take-off, or its editor. */
export function ChecklistContent() {
  const { t } = useTranslation();
  const checklist = usePart(CHECKLIST);
  const list = useStore(checklist.store, (state) => state.list);
  const failure = useStore(checklist.store, (state) => state.failure);
  const sentence = useSentence();
  const [isEdited, setEdited] = useState(false);
  const isPast = useIsPast();
  useEffect(() => void checklist.read(), [checklist]);
  if (list === null) {
    return failure === null ? (
      <p className="checklist-quiet">{t("checklist.reading")}</p>
    ) : (
      <Notice level="error">{sentence(failure)}</Notice>
    );
  }
  if (isEdited) {
    return <ChecklistEditor onClose={() => setEdited(false)} />;
  }
  return (
    <div className="checklist">
      {isPast && <Notice level="info">{t("checklist.past")}</Notice>}
      <Lines onEdit={() => setEdited(true)} />
    </div>
  );
}

function Lines({ onEdit }: { onEdit: () => void }) {
  const { t } = useTranslation();
  const checklist = usePart(CHECKLIST);
  const ticked = useStore(checklist.store, (state) => state.ticked);
  const items = useItems();
  useLooking();
  const isDone = ({ id, watched }: Item): boolean =>
    watched === null ? ticked.includes(id) : checklist.sees(watched);
  const done = items.filter(isDone).length;
  return (
    <>
      <p className="checklist-progress" role="status" data-ready={items.length > 0 && done === items.length}>
        {items.length > 0 && done === items.length
          ? t("checklist.ready")
          : t("checklist.progress", { done, all: items.length })}
      </p>
      {items.length === 0 && <p className="checklist-quiet">{t("checklist.empty")}</p>}
      <ol className="checklist-lines" aria-label={t("dialog.checklist")}>
        {items.map((item) => (
          <Line key={item.id} item={item} isDone={isDone(item)} />
        ))}
      </ol>
      <div className="checklist-tools">
        <Button onPress={checklist.again} icon={<RotateCcw size={14} aria-hidden="true" />}>
          {t("checklist.again")}
        </Button>
        <Button onPress={onEdit} icon={<Pencil size={14} aria-hidden="true" />}>
          {t("checklist.edit")}
        </Button>
        <Button onPress={() => window.print()} icon={<Printer size={14} aria-hidden="true" />}>
          {t("checklist.print")}
        </Button>
      </div>
    </>
  );
}

function Line({ item: { id, text, watched }, isDone }: { item: Item; isDone: boolean }) {
  const { t } = useTranslation();
  const checklist = usePart(CHECKLIST);
  const isPast = useIsPast();
  const byStation = watched === null ? undefined : t("checklist.byStation");
  return (
    <li className="checklist-line" data-done={isDone}>
      <Checkbox
        label={text}
        checked={isDone}
        onChange={(next) => checklist.tick(id, next)}
        disabledReason={byStation ?? (isPast ? t("checklist.past") : undefined)}
      />
      {watched !== null && (
        <span className="checklist-seen">{t(isDone ? "checklist.seen" : "checklist.unseen")}</span>
      )}
    </li>
  );
}

/** Draw again twice a second: what the station sees changes by time alone. */
function useLooking(): void {
  const [, setLook] = useState(0);
  useEffect(() => {
    const timer = setInterval(() => setLook((look) => look + 1), LOOK_MS);
    return () => clearInterval(timer);
  }, []);
}
