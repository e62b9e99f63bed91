import { Pencil, Trash2, Undo2 } from "lucide-react";
import { useEffect, useId, useRef, useState } from "react";
import { useTranslation } from "react-i18next";
import { formatFlightTime } from "../../lib/moment";
import { useAsked } from "../../requests/useAsked";
import { usePart } from "../../store/hooks";
import { Button } from "../../ui/Button";
import type { Mark } from "./flightLibrary";
import { FLIGHTS } from "./flightLibrary";
import { useLibrary, useLibraryUnreachable } from "./useFlights";

const LONGEST_TEXT = 200;

interface Props {
  readonly flight: string;
  readonly mark: Mark;
}

/** Beside a mark: its words can be changed, and it can be taken out. */
export function MarkTools({ flight, mark }: Props) {
  const { t } = useTranslation();
  const { changeMark, removeMark } = usePart(FLIGHTS);
  const [isOpen, setOpen] = useState(false);
  const blocked = useLibraryUnreachable();
  const name = { time: formatFlightTime(mark.at_s, 1), text: mark.text };
  const change = `flights.mark.${mark.id}`;
  const remove = `flights.markRemove.${mark.id}`;
  const changed = useAsked(change);
  const removed = useAsked(remove);
  if (isOpen) {
    return (
      <MarkWords
        mark={mark}
        onDone={(text) => {
          setOpen(false);
          if (text !== null && text !== mark.text) {
            void changeMark(flight, mark, text, { control: change });
          }
        }}
      />
    );
  }
  return (
    <span className="flights-mark-tools">
      <Button
        onPress={() => setOpen(true)}
        label={t("flights.changeMark", name)}
        state={changed.state}
        stateText={changed.stateText}
        disabledReason={blocked}
        icon={<Pencil size={14} aria-hidden="true" />}
      >
        {null}
      </Button>
      <Button
        onPress={() => void removeMark(flight, mark, { control: remove })}
        label={t("flights.removeMark", name)}
        state={removed.state}
        stateText={removed.stateText}
        disabledReason={blocked}
        icon={<Trash2 size={14} aria-hidden="true" />}
      >
        {null}
      </Button>
    </span>
  );
}

/** Enter and leaving the field keep the words; Escape, and no words at all, leave the mark as it was. */
function MarkWords({
  mark,
  onDone,
}: {
  readonly mark: Mark;
  readonly onDone: (text: string | null) => void;
}) {
  const { t } = useTranslation();
  const id = useId();
  const field = useRef<HTMLInputElement>(null);
  const isDone = useRef(false);
  useEffect(() => field.current?.focus(), []);
  const finish = (text: string | null): void => {
    if (!isDone.current) {
      isDone.current = true;
      onDone(text === null || text.trim() === "" ? null : text.trim());
    }
  };
  return (
    <span className="flights-mark-words">
      <label htmlFor={id} className="visually-hidden">
        {t("flights.markWords")}
      </label>
      <input
        ref={field}
        id={id}
        className="flights-mark-input"
        type="text"
        autoComplete="off"
        maxLength={LONGEST_TEXT}
        defaultValue={mark.text}
        onBlur={(event) => finish(event.currentTarget.value)}
        onKeyDown={(event) => {
          if (event.key === "Enter") {
            finish(event.currentTarget.value);
          } else if (event.key === "Escape") {
            // Escape is "back to now" elsewhere.
            event.stopPropagation();
            event.nativeEvent.stopImmediatePropagation();
            finish(null);
          }
        }}
      />
    </span>
  );
}

/** The newest change of a mark of this flight, with the way back. */
export function MarkUndo({ flight }: { readonly flight: string }) {
  const { t } = useTranslation();
  const { undoMark } = usePart(FLIGHTS);
  const change = useLibrary(({ markChange }) => markChange);
  const asked = useAsked("flights.markUndo");
  const blocked = useLibraryUnreachable();
  if (change === null || change.flight !== flight) {
    return null;
  }
  return (
    <div className="flights-deleted" role="status">
      <span>
        {t(change.kind === "changed" ? "flights.markChanged" : "flights.markRemoved", {
          text: change.mark.text,
        })}
      </span>
      <Button
        onPress={() => void undoMark(change, { control: "flights.markUndo" })}
        state={asked.state}
        stateText={asked.stateText}
        disabledReason={blocked}
        icon={<Undo2 size={14} aria-hidden="true" />}
      >
        {t("flights.undoMark")}
      </Button>
    </div>
  );
}
