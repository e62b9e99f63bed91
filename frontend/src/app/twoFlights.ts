import { createFlightComparison, type FlightComparison } from "../features/flights/flightComparison";
import type { Plots } from "../features/plots/plots";
import type { Reports } from "../features/report/reportRequests";
import { choose, type SettingsStore } from "../store/settings";

/** What can be done with two flights chosen in the library: their report, and one plotted over the other. */
export function twoFlights(parts: {
  readonly reports: Pick<Reports, "open">;
  readonly plots: Pick<Plots, "compare">;
  readonly settings: SettingsStore;
}): FlightComparison {
  const { reports, plots, settings } = parts;
  const comparison = createFlightComparison();
  comparison.register({
    words: "report.open",
    open: (first, second) => {
      // Ids begin with the time: the later flight is compared with the earlier one.
      const [earlier, later] = [first, second].sort();
      reports.open(later ?? second, earlier);
    },
  });
  comparison.register({
    words: "plots.compareTwo",
    open: (flight, other) => {
      plots.compare(flight, other);
      choose(settings, "tab", "plots");
    },
  });
  return comparison;
}
