import { ArrowDown, ArrowUp, Plus, Trash2 } from "lucide-react";
import { useRef, useState } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useSentence } from "../../i18n/useSentence";
import { usePart } from "../../store/hooks";
import type { Message } from "../../store/messages";
import { Button } from "../../ui/Button";
import { Notice } from "../../ui/Notice";
import { Select } from "../../ui/Select";
import { TextField } from "../../ui/TextField";
import { CHECKLIST, WATCHED } from "./checklist";
import { type Item, useItems } from "./useItems";

const PERSON = "person";
const MOST_LINES = 100;

/** The lines as fields: written, moved, added, taken away; kept for everybody with one press. */
export function ChecklistEditor({ onClose }: { onClose: () => void }) {
  const { t } = useTranslation();
  const sentence = useSentence();
  const checklist = usePart(CHECKLIST);
  const isOwn = useStore(checklist.store, (state) => state.list?.isOwn !== false);
  const version = useStore(checklist.store, (state) => state.version);
  const begun = useRef(version);
  const [draft, setDraft] = useState<readonly Item[]>(useItems());
  const [failure, setFailure] = useState<Message | null>(null);
  const added = useRef(0);

  function change(id: string, part: Partial<Item>): void {
    setDraft((lines) => lines.map((line) => (line.id === id ? { ...line, ...part } : line)));
  }

  function move(from: number, by: -1 | 1): void {
    setDraft((lines) => {
      const moved = [...lines];
      const [line] = moved.splice(from, 1);
      return line === undefined ? lines : moved.toSpliced(Math.max(0, from + by), 0, line);
    });
  }

  async function keep(lines: readonly Item[] | null): Promise<void> {
    const kept = lines
      ?.filter(({ text }) => text.trim() !== "")
      .map(({ text, watched }) => ({ text: text.trim(), watched }));
    const refused = await checklist.keep(kept ?? null);
    setFailure(refused);
    if (refused === null) {
      onClose();
    }
  }

  return (
    <div className="checklist">
      {version !== begun.current && <Notice level="warning">{t("checklist.changedElsewhere")}</Notice>}
      {failure !== null && <Notice level="error">{sentence(failure)}</Notice>}
      <ol className="checklist-lines">
        {draft.map((line, index) => (
          <li key={line.id} className="checklist-edited">
            <TextField
              label={t("checklist.text", { number: index + 1 })}
              hideLabel
              value={line.text}
              onCommit={(text) => change(line.id, { text: text.slice(0, 200) })}
            />
            <Select
              label={t("checklist.watched")}
              hideLabel
              placeholder={t("checklist.person")}
              value={line.watched ?? PERSON}
              options={[
                { value: PERSON, label: t("checklist.person") },
                ...WATCHED.map((value) => ({ value, label: t(`checklistWatch.${value}`) })),
              ]}
              onChange={(value) => change(line.id, { watched: value === PERSON ? null : value })}
            />
            <Button
              label={t("checklist.up", { text: line.text })}
              onPress={() => move(index, -1)}
              icon={<ArrowUp size={14} aria-hidden="true" />}
            >
              {null}
            </Button>
            <Button
              label={t("checklist.down", { text: line.text })}
              onPress={() => move(index, 1)}
              icon={<ArrowDown size={14} aria-hidden="true" />}
            >
              {null}
            </Button>
            <Button
              label={t("checklist.remove", { text: line.text })}
              onPress={() => setDraft(draft.filter(({ id }) => id !== line.id))}
              icon={<Trash2 size={14} aria-hidden="true" />}
            >
              {null}
            </Button>
          </li>
        ))}
      </ol>
      <div className="checklist-tools">
        {draft.length < MOST_LINES && (
          <Button
            onPress={() => {
              added.current += 1;
              setDraft([...draft, { id: `added.${added.current}`, text: "", watched: null }]);
            }}
            icon={<Plus size={14} aria-hidden="true" />}
          >
            {t("checklist.add")}
          </Button>
        )}
        {!isOwn && <Button onPress={() => void keep(null)}>{t("checklist.original")}</Button>}
        <Button onPress={onClose}>{t("checklist.cancel")}</Button>
        <Button onPress={() => void keep(draft)}>{t("checklist.save")}</Button>
      </div>
    </div>
  );
}
