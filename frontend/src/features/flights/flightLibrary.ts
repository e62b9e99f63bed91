import { createStore, type StoreApi } from "zustand/vanilla";
import type {
  DeletedFlight,
  Flight,
  FlightEvent,
  FlightList,
  FlightPolicy,
  Job,
} from "../../protocol/guards.gen";
import type { Asker } from "../../requests/asking";
import type { ConnectionStore } from "../../store/connection";
import type { Message } from "../../store/messages";
import { partName } from "../../store/parts";
import type { Language } from "../../store/settings";
import { ALL_FLIGHTS, type FlightQuery } from "./flightQuery";

/** A mark of a flight, as it was before the change that can be undone. */
export interface Mark {
  readonly id: string;
  readonly at_s: number;
  readonly text: string;
}

/** The newest change of a mark; one press takes it back. */
export interface MarkChange {
  readonly flight: string;
  readonly mark: Mark;
  readonly kind: "changed" | "removed";
}

/** The files that hold a recording, and the logs of other programs that are taken in as one. */
export const RECORDING_FILES = ".mcap,.ulg,.bin,.tlog,.csv";

/** What a flight can be turned into, the most useful first. */
export const EXPORT_FORMATS = [
  "mcap",
  "mcap-decoded",
  "csv",
  "parquet",
  "kml",
  "kmz",
  "gpx",
  "czml",
] as const;
export type ExportFormat = (typeof EXPORT_FORMATS)[number];

/** A file that is being sent to the station. */
export interface Upload {
  readonly key: number;
  readonly name: string;
  readonly bytes: number;
  readonly sent_bytes: number;
  /** Why it was not taken. */
  readonly failure: Message | null;
}

/** What happened in the selected flight; `events` is null until read. */
export interface FlightStory {
  readonly flight: string;
  readonly events: readonly FlightEvent[] | null;
  readonly failure: Message | null;
}

/** The library as the page knows it. It is of the station, and the same while the past is shown. */
export interface LibraryState {
  readonly query: FlightQuery;
  /** Null until read. */
  readonly list: FlightList | null;
  readonly failure: Message | null;
  readonly selected: string | null;
  readonly story: FlightStory | null;
  /** At most two, in the order in which they were chosen. */
  readonly compared: readonly string[];
  /** By id: what prepares, imports and exports flights, and what ended lately. */
  readonly jobs: Readonly<Record<string, Job>>;
  /** Ended jobs that the person has taken note of. */
  readonly dismissed: readonly string[];
  /** Jobs that export flights, begun on this page and under way. */
  readonly ownExports: readonly string[];
  readonly uploads: readonly Upload[];
  /** The names of the files that were sent from this page, by their job. */
  readonly files: Readonly<Record<string, string>>;
  readonly bin: readonly DeletedFlight[] | null;
  readonly binFailure: Message | null;
  /** Deleted from this page, newest first: each can be brought back with one press. */
  readonly deleted: readonly Pick<Flight, "id" | "title" | "started_s">[];
  /** The newest change of a mark made here; null if there was none, or it was undone. */
  readonly markChange: MarkChange | null;
  /** The past was opened from the list, which is drawn anew and gives the focus back to this flight. */
  readonly returnsTo: string | null;
}

export type LibraryStore = StoreApi<LibraryState>;

/** What a person says of a flight; what is left out stays. */
export type FlightWords = Partial<Pick<Flight, "title" | "notes" | "pinned" | "tags">>;

export interface ExportWish {
  readonly format: ExportFormat;
  /** Language of the names in it. */
  readonly lang: Language;
  /** Also the points that are less than a metre from the track. */
  readonly every_point: boolean;
  /** Seconds since the flight's start; null: the whole flight. */
  readonly from_s: number | null;
  readonly to_s: number | null;
}

/** The person's requests about flights; nothing here throws. */
export interface Flights {
  readonly store: LibraryStore;
  /** The present, whatever is shown: who has control, and what is being recorded. */
  readonly connection: ConnectionStore;
  /** Keep the list up to date until the returned function is called. */
  readonly watch: () => () => void;
  readonly read: () => Promise<void>;
  /** Change what is asked for; without a page it is the first. */
  readonly ask: (change: Partial<FlightQuery>) => void;
  /** Ask for these words, a moment after the last change of them. */
  readonly search: (text: string) => void;
  readonly select: (flight: string | null) => void;
  /** Show this moment of a flight on every tab; `at_s` since its start. */
  readonly open: (flight: string, at_s: number) => void;
  readonly openReport: (flight: string) => void;
  readonly changeMark: (flight: string, mark: Mark, text: string, asker: Asker) => Promise<void>;
  readonly removeMark: (flight: string, mark: Mark, asker: Asker) => Promise<void>;
  /** Take a change of a mark back; a removed one is set again. */
  readonly undoMark: (change: MarkChange, asker: Asker) => Promise<void>;
  readonly change: (flight: string, words: FlightWords, asker: Asker) => Promise<void>;
  readonly remove: (flight: Pick<Flight, "id" | "title" | "started_s">, asker: Asker) => Promise<void>;
  readonly restore: (flight: string, asker: Asker) => Promise<void>;
  readonly indexAgain: (flight: string, asker: Asker) => Promise<void>;
  readonly readBin: () => Promise<void>;
  readonly setPolicy: (policy: FlightPolicy, asker: Asker) => Promise<void>;
  /** What the aircraft is called from now on; empty for no name. */
  readonly setAircraft: (name: string, asker: Asker) => Promise<void>;
  /** Choose a flight to be compared, or leave it out again. */
  readonly compare: (flight: string, isChosen: boolean) => void;
  readonly importFile: (file: File) => Promise<void>;
  readonly cancelUpload: (key: number) => void;
  readonly export: (flight: string, wish: ExportWish, asker: Asker) => Promise<void>;
  readonly cancelJob: (job: string, asker: Asker) => Promise<void>;
  /** Take an ended job out of the list. */
  readonly dismissJob: (job: string) => void;
}

export const FLIGHTS = partName<Flights>("flights");

export function createLibrary(): LibraryStore {
  return createStore<LibraryState>(() => ({
    query: ALL_FLIGHTS,
    list: null,
    failure: null,
    selected: null,
    story: null,
    compared: [],
    jobs: {},
    dismissed: [],
    ownExports: [],
    uploads: [],
    files: {},
    bin: null,
    binFailure: null,
    deleted: [],
    markChange: null,
    returnsTo: null,
  }));
}

export function isOver({ state }: Pick<Job, "state">): boolean {
  return state === "done" || state === "failed" || state === "cancelled";
}
