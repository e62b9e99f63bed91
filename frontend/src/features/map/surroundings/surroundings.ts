import { createStore, type StoreApi } from "zustand/vanilla";
import type { Position } from "../../../lib/geodesy";
import { begun, edited, type History, redone, undone } from "../../../lib/history";
import type { StreamEvent } from "../../../protocol/envelope";
import { isFenceImport, isSurroundingsChoice, type SurroundingsChoice } from "../../../protocol/guards.gen";
import type { Gateway } from "../../../requests/asking";
import { failureMessage, type Message, wordsOf } from "../../../store/messages";
import { partName } from "../../../store/parts";

export type Corners = readonly Position[];

export interface SurroundingsState {
  /** What the station watches, for everybody; null until read. */
  readonly choice: SurroundingsChoice | null;
  /** The fence as it is drawn here, with its undo steps: it is the station's once it is saved. */
  readonly corners: History<Corners>;
  readonly failure: Message | null;
  /** What the file that was read last had, and what of it is not in the fence. */
  readonly said: readonly Message[];
}

export interface SurroundingsPart {
  readonly store: StoreApi<SurroundingsState>;
  readonly read: () => Promise<void>;
  /** Change some of the choice for everybody. */
  readonly choose: (part: Partial<SurroundingsChoice>) => Promise<void>;
  readonly edit: (corners: Corners) => void;
  readonly undo: () => void;
  readonly redo: () => void;
  /** Make the drawn fence the station's. */
  readonly save: () => Promise<void>;
  /** Draw the fence of this file. Its ceiling is told and not set: it would be watched at once. */
  readonly importFile: (file: File) => Promise<void>;
  /** A sentence about the file was read. */
  readonly forget: (message: Message) => void;
}

export const SURROUNDINGS = partName<SurroundingsPart>("surroundings");
export const LEAST_CORNERS = 3;
export const MOST_CORNERS = 100;

const PATH = "/api/v1/surroundings";
const NO_CORNERS: Corners = [];

/** Whether the drawn fence is the one that the station watches. */
export function isSaved({ choice, corners }: Pick<SurroundingsState, "choice" | "corners">): boolean {
  return JSON.stringify(choice?.corners ?? []) === JSON.stringify(corners.present);
}

export function createSurroundings(rest: Pick<Gateway, "ask">): {
  readonly surroundings: SurroundingsPart;
  readonly takeSurroundingsEvent: (event: StreamEvent) => void;
} {
  const store = createStore<SurroundingsState>(() => ({
    choice: null,
    corners: begun(NO_CORNERS),
    failure: null,
    said: [],
  }));

  /** Edits that are not saved stay when somebody else saves another fence. */
  function take(choice: SurroundingsChoice): void {
    store.setState((before) => ({
      choice,
      failure: null,
      corners:
        before.choice === null || isSaved(before) ? followed(before.corners, choice.corners) : before.corners,
    }));
  }

  async function ask(change?: SurroundingsChoice): Promise<void> {
    const answer =
      change === undefined
        ? await rest.ask("GET", PATH, isSurroundingsChoice)
        : await rest.ask("PUT", PATH, isSurroundingsChoice, change);
    if (answer.ok) {
      take(answer.value);
    } else {
      store.setState({ failure: failureMessage(answer.problem) });
    }
  }

  async function choose(part: Partial<SurroundingsChoice>): Promise<void> {
    const { choice } = store.getState();
    if (choice !== null) {
      await ask({ ...choice, ...part });
    }
  }

  async function importFile(file: File): Promise<void> {
    const path = `${PATH}/fence/import?name=${encodeURIComponent(file.name)}`;
    const answer = await rest.ask("POST", path, isFenceImport, file);
    if (!answer.ok) {
      store.setState({ failure: failureMessage(answer.problem), said: [] });
      return;
    }
    const { corners, ceiling_ft, notes } = answer.value;
    const params = { file: file.name, count: corners.length };
    const ceiling: Message[] =
      ceiling_ft === null
        ? []
        : [{ level: "warning", key: "fenceNote.ceiling", params: { ceiling_ft: Math.round(ceiling_ft) } }];
    store.setState((before) => ({
      corners: edited(before.corners, corners),
      failure: null,
      said: [
        { level: "info", key: "map.around.saidRead", params },
        ...notes.map(
          ({ code, params }): Message => ({
            level: "warning",
            key: `fenceNote.${code}`,
            params: wordsOf(params),
            fallback: code,
          }),
        ),
        ...ceiling,
      ],
    }));
  }

  const change = (to: (history: History<Corners>) => History<Corners>) => (): void =>
    store.setState(({ corners }) => ({ corners: to(corners) }));

  return {
    surroundings: {
      store,
      read: () => ask(),
      importFile,
      forget: (message) => store.setState(({ said }) => ({ said: said.filter((one) => one !== message) })),
      choose,
      edit: (corners) => change((history) => edited(history, corners))(),
      undo: change(undone),
      redo: change(redone),
      save: async () => {
        const corners = store.getState().corners.present.map(({ latitude_deg, longitude_deg }) => ({
          latitude_deg,
          longitude_deg,
        }));
        const { choice } = store.getState();
        // Without a border and a ceiling there is nothing to watch.
        const isNone = corners.length === 0 && choice?.ceiling_ft === null;
        store.setState((before) => ({ corners: { ...before.corners, present: corners } }));
        await choose({ corners, ...(isNone ? { fence_on: false } : {}) });
      },
    },
    takeSurroundingsEvent: (event) => {
      if (event.event === "surroundings") {
        void ask();
      }
    },
  };
}

/** The same history where the station has what is drawn here; else the station's fence as an edit, which can be undone. */
function followed(history: History<Corners>, corners: Corners): History<Corners> {
  return JSON.stringify(history.present) === JSON.stringify(corners) ? history : edited(history, corners);
}
