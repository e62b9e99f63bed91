import { useEffect, useState } from "react";
import { useTranslation } from "react-i18next";
import { formatDateTime } from "../../lib/moment";
import { type Flight, isFlightList } from "../../protocol/guards.gen";
import { usePart } from "../../store/hooks";
import { NumberField } from "../../ui/NumberField";
import { Select } from "../../ui/Select";
import { PLOTS } from "./plots";
import { usePlotsState } from "./usePlots";

const NONE = "none";
const MOST_SHIFT_S = 100_000;

/** The flights that can be laid over; empty while they are not known. */
export function useFlights(subject: string | null): readonly Flight[] {
  const { rest } = usePart(PLOTS);
  const [flights, setFlights] = useState<readonly Flight[]>([]);
  useEffect(() => {
    let isWanted = subject !== null;
    if (isWanted) {
      void rest.ask("GET", "/api/v1/flights?per_page=200", isFlightList).then((answer) => {
        if (isWanted && answer.ok) {
          setFlights(answer.value.flights);
        }
      });
    }
    return () => {
      isWanted = false;
    };
  }, [rest, subject]);
  return flights;
}

/** How a flight is called: its title, or when it began. */
export function flightName(flights: readonly Flight[], id: string): string {
  const flight = flights.find((one) => one.id === id);
  return flight === undefined ? id : flight.title || formatDateTime(flight.started_s);
}

interface Props {
  readonly subject: string | null;
  readonly flights: readonly Flight[];
}

/** Choose the flight that is laid over, and where it begins. */
export function CompareControls({ subject, flights }: Props) {
  const { t } = useTranslation();
  const { store } = usePart(PLOTS);
  const compared = usePlotsState((state) => state.compared);
  const shift_s = usePlotsState((state) => state.shift_s);
  const others = flights.filter(({ id, active, state }) => id !== subject && !active && state === "indexed");
  return (
    <>
      <Select
        label={t("plots.compare")}
        placeholder={t("plots.compareNone")}
        value={compared ?? NONE}
        onChange={(id) => store.setState({ compared: id === NONE ? null : id, shift_s: 0 })}
        options={[
          { value: NONE, label: t("plots.compareNone") },
          ...(compared === null || others.some(({ id }) => id === compared)
            ? []
            : [{ value: compared, label: flightName(flights, compared) }]),
          ...others.map(({ id }) => ({ value: id, label: flightName(flights, id) })),
        ]}
      />
      {compared !== null && (
        <NumberField
          label={t("plots.shift")}
          unit={t("unit.s")}
          value={shift_s}
          minimum={0}
          maximum={MOST_SHIFT_S}
          step={1}
          onCommit={(value) => store.setState({ shift_s: value })}
        />
      )}
    </>
  );
}
