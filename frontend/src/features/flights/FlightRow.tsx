import { Pin, PinOff, Play } from "lucide-react";
import { type KeyboardEvent, memo } from "react";
import { useTranslation } from "react-i18next";
import { formatDateTime } from "../../lib/moment";
import type { Flight, Job } from "../../protocol/guards.gen";
import { useAsked } from "../../requests/useAsked";
import { usePart } from "../../store/hooks";
import { Button } from "../../ui/Button";
import { Checkbox } from "../../ui/Checkbox";
import { FlightPicture } from "./FlightPicture";
import { FLIGHTS } from "./flightLibrary";
import { useFlightFigures } from "./useFlightFigures";
import { flightName, useLibraryUnreachable } from "./useFlights";

interface Props {
  readonly flight: Flight;
  readonly isSelected: boolean;
  /** It is the flight that all tabs show. */
  readonly isShown: boolean;
  /** The one row of the list that the Tab key reaches; the arrow keys go on from it. */
  readonly isTabStop: boolean;
  /** Whether two flights can be compared anywhere, and this is one of those chosen. */
  readonly compared: boolean | null;
  /** What prepares it now. */
  readonly job: Job | null;
}

/** One flight: a press shows its details, Enter opens it. */
export const FlightRow = memo(function FlightRow(props: Props) {
  const { flight, isSelected, isShown, isTabStop, compared, job } = props;
  const { t } = useTranslation();
  const flights = usePart(FLIGHTS);
  const figures = useFlightFigures()(flight);
  const name = flightName(flight);

  function onKeyDown(event: KeyboardEvent): void {
    if (event.key === "Enter" && canOpen(flight)) {
      event.preventDefault();
      flights.open(flight.id, 0);
    }
  }

  return (
    <li className="flights-row" data-selected={isSelected} data-shown={isShown}>
      <button
        type="button"
        className="flights-pick"
        data-flight={flight.id}
        tabIndex={isTabStop ? 0 : -1}
        aria-current={isSelected ? "true" : undefined}
        onClick={() => flights.select(flight.id)}
        onKeyDown={onKeyDown}
        onDoubleClick={() => canOpen(flight) && flights.open(flight.id, 0)}
      >
        <FlightPicture thumbnail={flight.thumbnail} />
        <span className="flights-facts">
          <span className="flights-name">{name}</span>
          <span className="flights-about">
            {flight.title !== "" && <span>{formatDateTime(flight.started_s)}</span>}
            {[flight.board, flight.firmware]
              .filter((word) => word !== null && word !== "")
              .map((word) => (
                <span key={word}>{word}</span>
              ))}
            {flight.emulated && <Badge level="caution">{t("flights.emulated")}</Badge>}
            {flight.imported && (
              <Badge>{flight.log === null ? t("flights.imported") : t(`logKind.${flight.log}`)}</Badge>
            )}
            {isShown && <Badge level="past">{t("flights.shown")}</Badge>}
            {flight.state !== "indexed" && (
              <Badge level={flight.state === "damaged" ? "warning" : "plain"}>
                {t(`flightState.${flight.state}`)}
              </Badge>
            )}
            {flight.damage !== null && flight.log === null && (
              <Badge level="warning">{t("flights.cut")}</Badge>
            )}
            {flight.tags.map((tag) => (
              <span key={tag} className="flights-tag">
                {tag}
              </span>
            ))}
          </span>
        </span>
        <span className="flights-figures">
          {figures.map(({ name: key, label, text, isCaution }) => (
            <span key={key} className="flights-figure" data-figure={key} data-caution={isCaution}>
              <span className="flights-figure-label">{`${label} `}</span>
              <span className="flights-figure-text">{text ?? "—"}</span>
            </span>
          ))}
        </span>
      </button>
      {job !== null && (
        <label className="flights-preparing">
          <span>{t("flights.preparing")}</span>
          <progress max={1} value={job.state === "running" ? job.progress : undefined} />
        </label>
      )}
      <div className="flights-row-tools">
        {compared !== null && (
          <Checkbox
            label={t("flights.compareOne", { name })}
            checked={compared}
            onChange={(isChosen) => flights.compare(flight.id, isChosen)}
          />
        )}
        <PinButton flight={flight} />
        <OpenButton flight={flight} isBrief />
      </div>
    </li>
  );
});

/** Something of it can be looked at: what could not be read at all cannot. */
export function canOpen({ state }: Pick<Flight, "state">): boolean {
  return state !== "damaged" && state !== "unread";
}

function Badge({ children, level = "plain" }: { readonly children: string; readonly level?: string }) {
  return (
    <span className="flights-badge" data-level={level}>
      {children}
    </span>
  );
}

export function PinButton({ flight }: { readonly flight: Flight }) {
  const { t } = useTranslation();
  const flights = usePart(FLIGHTS);
  const control = `flights.pin.${flight.id}`;
  const { state, stateText } = useAsked(control);
  const name = flightName(flight);
  return (
    <Button
      onPress={() => void flights.change(flight.id, { pinned: !flight.pinned }, { control })}
      pressed={flight.pinned}
      icon={flight.pinned ? <Pin size={15} aria-hidden="true" /> : <PinOff size={15} aria-hidden="true" />}
      label={t("flights.pin", { name })}
      state={state === "rejected" ? state : "idle"}
      stateText={state === "rejected" ? stateText : undefined}
      disabledReason={useLibraryUnreachable("operator")}
    >
      {null}
    </Button>
  );
}

export function OpenButton({
  flight,
  isBrief = false,
}: {
  readonly flight: Flight;
  readonly isBrief?: boolean;
}) {
  const { t } = useTranslation();
  const flights = usePart(FLIGHTS);
  const unreachable = useLibraryUnreachable();
  return (
    <Button
      variant={isBrief ? "plain" : "primary"}
      onPress={() => flights.open(flight.id, 0)}
      icon={<Play size={14} aria-hidden="true" />}
      label={isBrief ? t("flights.openOne", { name: flightName(flight) }) : undefined}
      disabledReason={canOpen(flight) ? unreachable : t("flights.cannotOpen")}
    >
      {isBrief ? null : t("flights.open")}
    </Button>
  );
}
