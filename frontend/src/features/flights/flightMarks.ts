import { type FlightEvent, type FlightEvents, isFlightEvents } from "../../protocol/guards.gen";
import { type Gateway, info, type Requester } from "../../requests/asking";
import type { Flights, LibraryStore, Mark, MarkChange } from "./flightLibrary";

interface Parts {
  readonly rest: Gateway;
  readonly store: LibraryStore;
  readonly run: Requester["run"];
}

/** The mark of an event; null for any other event. */
export function markOf({ kind, id, at_s, data }: FlightEvent): Mark | null {
  const text = data["text"];
  return kind === "mark" && id !== null && typeof text === "string" ? { id, at_s, text } : null;
}

/** Marks of finished flights are changed beside the recording, which stays as it is. */
export function createFlightMarks({
  rest,
  store,
  run,
}: Parts): Pick<Flights, "changeMark" | "removeMark" | "undoMark"> {
  const marksOf = (flight: string): string => `/api/v1/flights/${flight}/marks`;

  function show(flight: string, { events }: FlightEvents, markChange: MarkChange | null): void {
    store.setState(({ story, list }) => ({
      markChange,
      story: story?.flight === flight ? { flight, events, failure: null } : story,
      list: list && {
        ...list,
        flights: list.flights.map((one) =>
          one.id === flight ? { ...one, marks: events.filter(({ kind }) => kind === "mark").length } : one,
        ),
      },
    }));
  }

  return {
    changeMark: (flight, mark, text, asker) =>
      run(asker, rest.ask("PATCH", `${marksOf(flight)}/${mark.id}`, isFlightEvents, { text }), (events) => {
        show(flight, events, { flight, mark, kind: "changed" });
        return { state: "confirmed", message: info("flights.saidMarkChanged") };
      }),
    removeMark: (flight, mark, asker) =>
      run(asker, rest.ask("DELETE", `${marksOf(flight)}/${mark.id}`, isFlightEvents), (events) => {
        show(flight, events, { flight, mark, kind: "removed" });
        return { state: "confirmed", message: info("flights.saidMarkRemoved") };
      }),
    undoMark: ({ flight, mark: { id, at_s, text }, kind }, asker) =>
      run(
        asker,
        kind === "changed"
          ? rest.ask("PATCH", `${marksOf(flight)}/${id}`, isFlightEvents, { text })
          : rest.ask("POST", marksOf(flight), isFlightEvents, { text, at_s }),
        (events) => {
          show(flight, events, null);
          return { state: "confirmed", message: info("flights.saidMarkUndone") };
        },
      ),
  };
}
