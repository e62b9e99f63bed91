import { createStore, type StoreApi } from "zustand/vanilla";
import { type FaultChoice, isFaultTable, type WindState } from "../../protocol/guards.gen";
import { createAsking, info, type RequesterParts } from "../../requests/asking";
import { failureMessage, type Message } from "../../store/messages";
import { partName } from "../../store/parts";

export interface FaultTableState {
  /** The faults that the simulator can fly; null until read. */
  readonly choices: readonly FaultChoice[] | null;
  readonly failure: Message | null;
}

/** A fault to begin: strength in the station's unit, `length_s` null until somebody ends it. */
export interface FaultRequest {
  readonly place: FaultChoice["place"];
  readonly kind: FaultChoice["kind"];
  readonly start_s: number;
  readonly length_s: number | null;
  readonly strength: number | null;
}

/** Lets things go wrong in the embedded simulator; none throws. */
export interface Faults {
  readonly store: StoreApi<FaultTableState>;
  readonly read: () => Promise<void>;
  readonly begin: (fault: FaultRequest) => Promise<void>;
  /** End one, or all without an id. */
  readonly end: (id?: string) => Promise<void>;
  readonly blow: (wind: WindState) => Promise<void>;
}

export const FAULTS = partName<Faults>("faults");
/** The controls whose progress is shown. */
export const BEGIN = "faults.begin";
export const END_ALL = "faults.endAll";
export const BLOW = "faults.wind";

const PATH = "/api/v1/faults";

export function createFaults(parts: RequesterParts): Faults {
  const { simply } = createAsking(parts);
  const store = createStore<FaultTableState>(() => ({ choices: null, failure: null }));
  return {
    store,
    read: async () => {
      const answer = await parts.rest.ask("GET", PATH, isFaultTable);
      store.setState(
        answer.ok
          ? { choices: answer.value.choices, failure: null }
          : { failure: failureMessage(answer.problem) },
      );
    },
    begin: (fault) =>
      simply(
        { control: BEGIN },
        ["POST", PATH, fault],
        info("said.faultAsked", { place: `@faultPlace.${fault.place}`, kind: `@faultKind.${fault.kind}` }),
      ),
    end: (id) =>
      id === undefined
        ? simply({ control: END_ALL }, ["DELETE", PATH], info("said.faultsEnded"))
        : simply(
            { control: `faults.end.${id}` },
            ["DELETE", `${PATH}/${encodeURIComponent(id)}`],
            info("said.oneFaultEnded"),
          ),
    blow: (wind) =>
      simply(
        { control: BLOW },
        ["PUT", `${PATH}/wind`, wind],
        info("said.windSet", {
          from_deg: wind.from_deg,
          speed_kt: wind.speed_kt,
          turbulence: `@turbulence.${wind.turbulence}`,
        }),
      ),
  };
}
