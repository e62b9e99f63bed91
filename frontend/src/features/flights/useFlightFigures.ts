import { useTranslation } from "react-i18next";
import { formatBytes } from "../../lib/format";
import { formatFlightTime } from "../../lib/moment";
import type { Flight } from "../../protocol/guards.gen";
import { type Unit, useUnit } from "../../readouts/useUnit";

/** One number of a flight with its name; `text` is null where the recording does not say. */
export interface Figure {
  readonly name: string;
  readonly label: string;
  readonly text: string | null;
  /** Something that deserves a look. */
  readonly isCaution: boolean;
}

/** The numbers of a flight in the units that the person chose. */
export function useFlightFigures(): (flight: Flight) => readonly Figure[] {
  const { t } = useTranslation();
  const altitude = useUnit("altitude", "ft");
  const speed = useUnit("speed", "kt");
  const distance = useUnit("distance", "nm");
  const figure = (name: string, label: string, text: string | null, isCaution = false): Figure => ({
    name,
    label,
    text,
    isCaution,
  });
  return (flight) => [
    figure(
      "duration",
      t("flights.duration"),
      flight.duration_s === null ? null : formatFlightTime(flight.duration_s),
    ),
    figure("distance", t("flights.distance"), withUnit(flight.distance_nm, distance)),
    figure("highest", t("flights.highest"), withUnit(flight.highest_ft, altitude)),
    figure("fastest", t("flights.fastest"), withUnit(flight.fastest_kt, speed)),
    figure("alarms", t("flights.alarms"), count(flight.alarms), (flight.alarms ?? 0) > 0),
    figure("damaged", t("flights.damaged"), count(flight.frames_damaged), (flight.frames_damaged ?? 0) > 0),
    figure("marks", t("flights.marks"), count(flight.marks)),
    figure("bytes", t("flights.size"), formatBytes(flight.bytes)),
  ];
}

function withUnit(value: number | null, unit: Unit): string | null {
  const text = value === null ? null : unit.format(value);
  return text === null ? null : `${text} ${unit.label}`;
}

function count(value: number | null): string | null {
  return value === null ? null : String(value);
}
