import { Polling } from "../../lib/repeating";
import type { Timers } from "../../lib/timers";
import type { StreamEvent } from "../../protocol/envelope";
import {
  isFlight,
  isFlightAircraft,
  isFlightBin,
  isFlightDisk,
  isFlightEvents,
  isFlightList,
  isJobList,
  type Job,
} from "../../protocol/guards.gen";
import { createAsking, info, type RequesterParts } from "../../requests/asking";
import type { ConnectionStore } from "../../store/connection";
import { failureMessage } from "../../store/messages";
import { createLibrary, type Flights, isOver, type LibraryState } from "./flightLibrary";
import { createFlightMarks } from "./flightMarks";
import { flightsPath } from "./flightQuery";
import { createFlightTransfers } from "./flightTransfers";
import { runningFlight } from "./runningFlight";

const FLIGHTS_PATH = "/api/v1/flights";
/** What other people change is seen this late. */
const EVERY_MS = 30_000;
/** Long enough not to ask with each letter. */
const TYPING_MS = 300;
/** Flights deleted here that are offered to be brought back at once; all others are in the bin. */
const MOST_DELETED = 3;

interface Parts extends RequesterParts {
  readonly timers: Timers;
  /** The present. */
  readonly connection: ConnectionStore;
  readonly openFlight: (flight: string, at_s: number) => void;
  readonly play: () => void;
  /** The flight is gone: whoever looks at it goes back to now. */
  readonly onGone: (flight: string) => void;
  readonly openReport: (flight: string) => void;
}

/** The requests about flights, with their outcome in the library's store. */
export function createFlights(parts: Parts): {
  readonly flights: Flights;
  readonly takeFlightEvent: (event: StreamEvent) => void;
} {
  const { rest, timers, messages, connection, openFlight, play, onGone, openReport } = parts;
  const { run } = createAsking(parts);
  const store = createLibrary();
  let asked = 0;
  let cancelTyping: () => void = () => undefined;

  async function readList(): Promise<void> {
    asked += 1;
    const mine = asked;
    const answer = await rest.ask("GET", flightsPath(store.getState().query), isFlightList);
    if (mine !== asked) {
      return;
    }
    if (answer.ok) {
      const { indexing } = answer.value;
      store.setState(({ jobs }) => ({ list: answer.value, failure: null, jobs: withJobs(jobs, indexing) }));
    } else {
      store.setState({ failure: failureMessage(answer.problem) });
    }
  }
  const polling = new Polling(timers, EVERY_MS, readList);
  const { read } = polling;

  /** After a change that can bring or take away flights. */
  function readAgain(): void {
    if (polling.isWatched) {
      read();
    }
  }

  async function readJobs(): Promise<void> {
    const answer = await rest.ask("GET", "/api/v1/jobs", isJobList);
    if (answer.ok) {
      store.setState(({ jobs }) => ({ jobs: withJobs(jobs, answer.value.jobs) }));
    }
  }

  async function readStory(flight: string): Promise<void> {
    const answer = await rest.ask("GET", `${FLIGHTS_PATH}/${flight}/events`, isFlightEvents);
    if (store.getState().selected === flight) {
      store.setState({
        story: answer.ok
          ? { flight, events: answer.value.events, failure: null }
          : { flight, events: null, failure: failureMessage(answer.problem) },
      });
    }
  }

  function select(flight: string | null, isPrepared = true): void {
    if (flight !== store.getState().selected) {
      store.setState({
        selected: flight,
        story: flight === null ? null : { flight, events: null, failure: null },
      });
    }
    // What happened in a flight that is being prepared is read when that is done.
    const state = store.getState().list?.flights.find(({ id }) => id === flight)?.state;
    if (flight !== null && isPrepared && state !== "waiting" && state !== "indexing") {
      void readStory(flight);
    }
  }

  async function readBin(): Promise<void> {
    const answer = await rest.ask("GET", `${FLIGHTS_PATH}/bin`, isFlightBin);
    store.setState(
      answer.ok
        ? { bin: answer.value.flights, binFailure: null }
        : { binFailure: failureMessage(answer.problem) },
    );
  }

  /** Put one flight as the gateway has it now into the list. */
  function replace(flight: NonNullable<LibraryState["list"]>["flights"][number]): void {
    store.setState(({ list }) => ({
      list: list && {
        ...list,
        flights: list.flights.map((before) => (before.id === flight.id ? flight : before)),
      },
    }));
  }

  function takeFlightEvent({ event, data }: StreamEvent): void {
    if (event === "job") {
      takeJob(data);
    }
  }

  function takeJob(job: Job): void {
    store.setState(({ jobs }) => ({ jobs: withJobs(jobs, [job]) }));
    if (isOver(job)) {
      ended(job);
    }
  }

  function ended({ id, kind, state, flight, result }: Job): void {
    // Its link may be out of sight: the list can be scrolled.
    const isOwn = store.getState().ownExports.includes(id);
    store.setState(({ ownExports }) => ({ ownExports: ownExports.filter((job) => job !== id) }));
    if (result !== null && isOwn) {
      messages.announce(info("flights.saidExported", { name: result.name }));
    }
    if (kind === "import" && state === "done" && flight !== null && id in store.getState().files) {
      select(flight, false);
    }
    if (kind === "index" && flight !== null && flight === store.getState().selected) {
      void readStory(flight);
    }
    if (kind !== "export" && kind !== "report" && kind !== "backup") {
      readAgain();
    }
  }

  // The recording that ended becomes a flight of the list.
  connection.subscribe((now, before) => {
    if (runningFlight(now)?.id !== runningFlight(before)?.id) {
      readAgain();
    }
  });

  const flights: Flights = {
    store,
    connection,
    read: readList,
    select: (flight) => select(flight),
    readBin,

    watch: () => {
      const isFirst = !polling.isWatched;
      const end = polling.watch();
      if (isFirst) {
        void readJobs();
      }
      return end;
    },

    ask: (change) => {
      store.setState(({ query }) => ({ query: { ...query, page: 1, ...change } }));
      read();
    },

    search: (text) => {
      store.setState(({ query }) => ({ query: { ...query, text, page: 1 } }));
      cancelTyping();
      cancelTyping = timers.after(TYPING_MS, () => read());
    },

    open: (flight, at_s) => {
      store.setState(({ selected }) => ({ returnsTo: selected }));
      openFlight(flight, at_s);
      if (at_s === 0) {
        // Who begins at the start wants to see it fly: before the first frames there is nothing to look at.
        play();
      }
    },

    openReport,

    change: (flight, words, asker) =>
      run(asker, rest.ask("PATCH", `${FLIGHTS_PATH}/${flight}`, isFlight, words), (changed) => {
        replace(changed);
        if (words.tags !== undefined) {
          readAgain();
        }
        return { state: "confirmed", message: info("flights.saidChanged") };
      }),

    remove: ({ id, title, started_s }, asker) =>
      run(asker, rest.ask("DELETE", `${FLIGHTS_PATH}/${id}?confirm=${id}`, isFlightBin), (bin) => {
        store.setState(({ selected, story, compared, deleted }) => ({
          bin: bin.flights,
          deleted: [{ id, title, started_s }, ...deleted].slice(0, MOST_DELETED),
          compared: compared.filter((one) => one !== id),
          ...(selected === id ? { selected: null, story: null } : { selected, story }),
        }));
        onGone(id);
        read();
        return { state: "confirmed", message: info("flights.saidDeleted") };
      }),

    restore: (flight, asker) =>
      run(asker, rest.ask("POST", `${FLIGHTS_PATH}/${flight}/restore`, isFlight), ({ id }) => {
        store.setState(({ deleted, bin }) => ({
          deleted: deleted.filter((one) => one.id !== id),
          bin: bin?.filter((one) => one.id !== id) ?? null,
        }));
        read();
        return { state: "confirmed", message: info("flights.saidRestored") };
      }),

    indexAgain: (flight, asker) =>
      run(asker, rest.ask("POST", `${FLIGHTS_PATH}/${flight}/index`, isFlight), (changed) => {
        replace(changed);
        return { state: "confirmed", message: info("flights.saidIndexing") };
      }),

    setPolicy: (policy, asker) =>
      run(asker, rest.ask("PUT", `${FLIGHTS_PATH}/policy`, isFlightDisk, policy), (disk) => {
        store.setState(({ list }) => ({ list: list && { ...list, disk } }));
        return { state: "confirmed", message: info("flights.saidPolicy") };
      }),

    setAircraft: (name, asker) =>
      run(asker, rest.ask("PUT", `${FLIGHTS_PATH}/aircraft`, isFlightAircraft, { name }), (named) => {
        store.setState(({ list }) => ({ list: list && { ...list, aircraft: named.name } }));
        return { state: "confirmed", message: info("flights.saidAircraft") };
      }),

    compare: (flight, isChosen) =>
      store.setState(({ compared }) => {
        const others = compared.filter((one) => one !== flight);
        return { compared: isChosen ? [...others, flight].slice(-2) : others };
      }),

    ...createFlightMarks({ rest, store, run }),
    ...createFlightTransfers({ rest, store, run, onJob: takeJob }),
  };
  return { flights, takeFlightEvent };
}

/** With these jobs of an answer, which may be older than an event that came before it: what has ended stays ended. */
function withJobs(jobs: LibraryState["jobs"], told: readonly Job[]): LibraryState["jobs"] {
  const taken = told.filter((job) => {
    const before = jobs[job.id];
    return before === undefined || isOver(job) || !isOver(before);
  });
  return { ...jobs, ...Object.fromEntries(taken.map((job) => [job.id, job])) };
}
