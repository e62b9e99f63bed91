import {
  AlertTriangle,
  Bookmark,
  CircleOff,
  Lightbulb,
  MapPin,
  SlidersHorizontal,
  Terminal,
} from "lucide-react";
import { useState } from "react";
import { useTranslation } from "react-i18next";
import { useSentence } from "../../i18n/useSentence";
import { formatFlightTime } from "../../lib/moment";
import type { Flight, FlightEvent } from "../../protocol/guards.gen";
import { usePart } from "../../store/hooks";
import { Button } from "../../ui/Button";
import { Notice } from "../../ui/Notice";
import { EVENT_GROUPS, type EventGroup, eventMessage, groupOf } from "./flightEvents";
import { FLIGHTS } from "./flightLibrary";
import { markOf } from "./flightMarks";
import { MarkTools, MarkUndo } from "./MarkTools";
import { useLibrary } from "./useFlights";

const ICONS = {
  command: Terminal,
  alarm: AlertTriangle,
  advice: Lightbulb,
  mode: SlidersHorizontal,
  waypoint: MapPin,
  mark: Bookmark,
  trouble: CircleOff,
} as const;
/** The browser stays quick with this many; the others follow on demand. */
const FIRST = 200;

/** What happened in the flight; a press opens it at that moment. */
export function FlightStory({ flight }: { readonly flight: Flight }) {
  const { t } = useTranslation();
  const sentence = useSentence();
  const story = useLibrary((library) => library.story);
  const [hidden, setHidden] = useState<readonly EventGroup[]>([]);
  const [most, setMost] = useState(FIRST);
  if (story === null || story.flight !== flight.id || (story.events === null && story.failure === null)) {
    return <p className="flights-quiet">{t("flights.readingEvents")}</p>;
  }
  if (story.events === null) {
    return <Notice level="warning">{story.failure === null ? "" : sentence(story.failure)}</Notice>;
  }
  const there = EVENT_GROUPS.filter((group) => story.events?.some((event) => groupOf(event) === group));
  const shown = story.events.filter((event) => !hidden.includes(groupOf(event)));
  if (story.events.length === 0) {
    return (
      <>
        <MarkUndo flight={flight.id} />
        <p className="flights-quiet">{t("flights.noEvents")}</p>
      </>
    );
  }
  return (
    <>
      <MarkUndo flight={flight.id} />
      <fieldset className="flights-groups">
        <legend className="visually-hidden">{t("flights.eventGroups")}</legend>
        {there.map((group) => (
          <Button
            key={group}
            pressed={!hidden.includes(group)}
            onPress={() =>
              setHidden(hidden.includes(group) ? hidden.filter((one) => one !== group) : [...hidden, group])
            }
          >
            {t(`flightGroup.${group}`, {
              count: story.events?.filter((event) => groupOf(event) === group).length ?? 0,
            })}
          </Button>
        ))}
      </fieldset>
      <ol className="flights-events" aria-label={t("flights.events")}>
        {shown.slice(0, most).map((event, index) => (
          <EventRow key={event.id ?? index} flight={flight.id} event={event} />
        ))}
      </ol>
      {shown.length > most && (
        <Button onPress={() => setMost(most + 10 * FIRST)}>
          {t("flights.moreEvents", { count: shown.length - most })}
        </Button>
      )}
    </>
  );
}

function EventRow({ flight, event }: { readonly flight: string; readonly event: FlightEvent }) {
  const { t } = useTranslation();
  const sentence = useSentence();
  const { open } = usePart(FLIGHTS);
  const group = groupOf(event);
  const mark = markOf(event);
  const Icon = ICONS[group];
  const { at_s, t_s, until_s } = event;
  return (
    <li className="flights-story-line">
      <button
        type="button"
        className="flights-event"
        data-group={group}
        data-level={event.data["level"] === "critical" ? "critical" : undefined}
        onClick={() => open(flight, at_s)}
      >
        <Icon size={14} aria-hidden="true" />
        <span className="flights-number">{formatFlightTime(at_s, 1)}</span>
        <span className="flights-event-text">
          {sentence(eventMessage(event))}
          {until_s !== null && group !== "command" && (
            <span className="flights-quiet">
              {" "}
              {t("flights.lasted", { time: formatFlightTime(until_s - t_s, 1) })}
            </span>
          )}
        </span>
      </button>
      {mark !== null && <MarkTools flight={flight} mark={mark} />}
    </li>
  );
}
