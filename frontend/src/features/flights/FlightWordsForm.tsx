import { X } from "lucide-react";
import { useId, useState } from "react";
import { useTranslation } from "react-i18next";
import type { Flight } from "../../protocol/guards.gen";
import { useAsked } from "../../requests/useAsked";
import { usePart } from "../../store/hooks";
import { Notice } from "../../ui/Notice";
import { TextField } from "../../ui/TextField";
import { FLIGHTS, type FlightWords } from "./flightLibrary";
import { useLibrary, useLibraryUnreachable } from "./useFlights";

/** Longest texts that the station keeps. */
const [LONGEST_TITLE, LONGEST_TAG, MOST_TAGS, LONGEST_NOTES] = [200, 40, 20, 20_000];

/** Title, tags and notes. Each is kept when its field is left. */
export function FlightWordsForm({ flight }: { readonly flight: Flight }) {
  const { t } = useTranslation();
  const { change } = usePart(FLIGHTS);
  const control = `flights.words.${flight.id}`;
  const { state, stateText } = useAsked(control);
  const unreachable = useLibraryUnreachable("operator");
  const keep = (words: FlightWords): void => void change(flight.id, words, { control });
  return (
    <div className="flights-words">
      <TextField
        label={t("flights.title")}
        value={flight.title}
        disabledReason={unreachable}
        onCommit={(title) => keep({ title: title.trim().slice(0, LONGEST_TITLE) })}
      />
      <Tags flight={flight} keep={keep} />
      <Notes key={flight.id} flight={flight} keep={keep} />
      {state === "rejected" && <Notice level="error">{stateText}</Notice>}
    </div>
  );
}

interface Props {
  readonly flight: Flight;
  readonly keep: (words: FlightWords) => void;
}

function Tags({ flight: { tags }, keep }: Props) {
  const { t } = useTranslation();
  const known = useLibrary(({ list }) => list?.tags) ?? [];
  const unreachable = useLibraryUnreachable("operator");
  const offered = known.filter((tag) => !tags.includes(tag)).slice(0, 8);
  const add = (tag: string): void => {
    const added = tag.trim().slice(0, LONGEST_TAG);
    if (added !== "" && !tags.includes(added)) {
      keep({ tags: [...tags, added] });
    }
  };
  const why = tags.length >= MOST_TAGS ? t("flights.manyTags", { count: MOST_TAGS }) : undefined;
  return (
    <div className="flights-tags">
      <TextField
        label={t("flights.addTag")}
        value=""
        onCommit={add}
        hint={t("flights.addTagHint")}
        disabledReason={unreachable ?? why}
      />
      {tags.length > 0 && (
        <ul aria-label={t("flights.tags")}>
          {tags.map((tag) => (
            <li key={tag} className="flights-tag">
              {tag}
              <button
                type="button"
                className="flights-tag-button"
                aria-label={t("flights.removeTag", { tag })}
                onClick={() => unreachable ?? keep({ tags: tags.filter((one) => one !== tag) })}
              >
                <X size={12} aria-hidden="true" />
              </button>
            </li>
          ))}
        </ul>
      )}
      {offered.length > 0 && why === undefined && (
        <ul aria-label={t("flights.knownTags")}>
          {offered.map((tag) => (
            <li key={tag}>
              <button
                type="button"
                className="flights-tag flights-tag-offer"
                aria-label={t("flights.useTag", { tag })}
                onClick={() => unreachable ?? add(tag)}
              >
                {`+ ${tag}`}
              </button>
            </li>
          ))}
        </ul>
      )}
    </div>
  );
}

function Notes({ flight, keep }: Props) {
  const { t } = useTranslation();
  const id = useId();
  const [draft, setDraft] = useState<string | null>(null);
  const unreachable = useLibraryUnreachable("operator");
  return (
    <div className="ui-field">
      <label htmlFor={id} className="ui-field-label">
        {t("flights.notes")}
      </label>
      <textarea
        id={id}
        className="ui-field-input ui-field-line flights-notes"
        rows={4}
        maxLength={LONGEST_NOTES}
        value={draft ?? flight.notes}
        readOnly={unreachable !== undefined}
        onChange={(event) => setDraft(event.currentTarget.value)}
        onBlur={() => {
          if (draft !== null && draft !== flight.notes) keep({ notes: draft });
          setDraft(null);
        }}
      />
    </div>
  );
}
