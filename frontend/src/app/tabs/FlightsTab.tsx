import { useEffect } from "react";
import { useStore } from "zustand";
import { FlightsView } from "../../features/flights/FlightsView";
import { FLIGHTS } from "../../features/flights/flightLibrary";
import { flightName, useLibrary } from "../../features/flights/useFlights";
import { ReportView } from "../../features/report/ReportView";
import { REPORTS } from "../../features/report/reportRequests";
import { usePart } from "../../store/hooks";

/** The library of flights, or the report that is open in its place. */
export function FlightsTab() {
  const report = useStore(usePart(REPORTS).store, (open) => open?.flight ?? null);
  return report === null ? <FlightsView /> : <Report report={report} />;
}

function Report({ report }: { readonly report: string }) {
  const { watch } = usePart(FLIGHTS);
  useEffect(() => watch(), [watch]);
  const flights = useLibrary(({ list }) => list?.flights);
  const flight = flights?.find(({ id }) => id === report);
  const others = flights?.filter(({ state }) => state === "indexed") ?? [];
  return (
    <ReportView
      name={flight === undefined ? report : flightName(flight)}
      others={others.map((other) => ({ id: other.id, name: flightName(other) }))}
    />
  );
}
