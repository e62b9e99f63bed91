import { ChevronLeft, ChevronRight } from "lucide-react";
import { type KeyboardEvent, useEffect, useRef, useState } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import type { Flight, Job } from "../../protocol/guards.gen";
import { usePage, usePart } from "../../store/hooks";
import { Button } from "../../ui/Button";
import { FlightRow } from "./FlightRow";
import { FLIGHT_COMPARISON } from "./flightComparison";
import { FLIGHTS, isOver } from "./flightLibrary";
import { isFiltered, PER_PAGE } from "./flightQuery";
import { useLibrary } from "./useFlights";

/** The flights that were asked for, without the one that is being recorded. Arrow keys move from one to the next. */
export function FlightRows({ flights }: { readonly flights: readonly Flight[] }) {
  const { t } = useTranslation();
  const { store } = usePart(FLIGHTS);
  const list = useRef<HTMLUListElement>(null);
  const { past } = usePage();
  const selected = useLibrary((library) => library.selected);
  const compared = useLibrary((library) => library.compared);
  const jobs = useLibrary((library) => library.jobs);
  const canCompare = useStore(usePart(FLIGHT_COMPARISON).views).length > 0;
  const [stop, setStop] = useState(selected);
  const tabStop = flights.some(({ id }) => id === stop) ? stop : flights[0]?.id;

  useEffect(() => {
    const { returnsTo } = store.getState();
    if (returnsTo !== null) {
      store.setState({ returnsTo: null });
      list.current?.querySelector<HTMLElement>(`[data-flight="${returnsTo}"]`)?.focus();
    }
  }, [store]);

  function onKeyDown(event: KeyboardEvent): void {
    const rows = [...(list.current?.querySelectorAll<HTMLElement>(".flights-pick") ?? [])];
    const at = rows.indexOf(event.target as HTMLElement);
    const next = at === -1 || event.shiftKey ? null : moved(event.key, at, rows.length);
    if (next !== null) {
      // The time bar has these keys too while nothing else uses them.
      event.preventDefault();
      event.stopPropagation();
      rows[next]?.focus();
    }
  }

  return (
    <ul
      ref={list}
      className="flights-list"
      aria-label={t("flights.list")}
      onKeyDown={onKeyDown}
      onFocus={({ target }) => {
        const flight = target.dataset["flight"];
        if (flight !== undefined) setStop(flight);
      }}
    >
      {flights.map((flight) => (
        <FlightRow
          key={flight.id}
          flight={flight}
          isSelected={flight.id === selected}
          isShown={flight.id === past}
          isTabStop={flight.id === tabStop}
          compared={canCompare && flight.state === "indexed" ? compared.includes(flight.id) : null}
          job={preparing(jobs, flight.id)}
        />
      ))}
    </ul>
  );
}

function moved(key: string, at: number, count: number): number | null {
  switch (key) {
    case "ArrowDown":
      return Math.min(count - 1, at + 1);
    case "ArrowUp":
      return Math.max(0, at - 1);
    case "Home":
      return 0;
    case "End":
      return count - 1;
    default:
      return null;
  }
}

function preparing(jobs: Readonly<Record<string, Job>>, flight: string): Job | null {
  return (
    Object.values(jobs).find(
      (job) => job.flight === flight && (job.kind === "index" || job.kind === "pack") && !isOver(job),
    ) ?? null
  );
}

/** How many there are, and the way to the others. */
export function FlightPages() {
  const { t } = useTranslation();
  const { ask } = usePart(FLIGHTS);
  const query = useLibrary((library) => library.query);
  const total = useLibrary(
    ({ list }) => (list?.total ?? 0) - (list?.flights.some(({ active }) => active) ? 1 : 0),
  );
  const pages = Math.max(1, Math.ceil(total / PER_PAGE));
  if (total === 0) {
    return null;
  }
  const count = t(isFiltered(query) ? "flights.found" : "flights.count", { count: total });
  return (
    <nav className="flights-pages" aria-label={t("flights.pages")}>
      <p role="status">{count}</p>
      {pages > 1 && (
        <>
          <Button
            onPress={() => ask({ page: query.page - 1 })}
            icon={<ChevronLeft size={15} aria-hidden="true" />}
            label={t("flights.pageBefore")}
            disabledReason={query.page > 1 ? undefined : t("flights.firstPage")}
          >
            {null}
          </Button>
          <span>{t("flights.page", { page: query.page, pages })}</span>
          <Button
            onPress={() => ask({ page: query.page + 1 })}
            icon={<ChevronRight size={15} aria-hidden="true" />}
            label={t("flights.pageAfter")}
            disabledReason={query.page < pages ? undefined : t("flights.lastPage")}
          >
            {null}
          </Button>
        </>
      )}
    </nav>
  );
}
