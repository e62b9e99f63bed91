import { createStore, type StoreApi } from "zustand/vanilla";
import type { StreamEvent } from "../../protocol/envelope";
import {
  type FieldEstimate,
  type FieldList,
  isFieldEstimate,
  isFieldList,
  isFieldProof,
  isMapLayers,
  isPreparedField,
  type MapLayer,
  type PreparedField,
} from "../../protocol/guards.gen";
import { type Asker, createAsking, info, type RequesterParts } from "../../requests/asking";
import { failureMessage, type Message } from "../../store/messages";
import { partName } from "../../store/parts";

export interface FieldOrder {
  readonly name: string;
  readonly points: readonly { readonly latitude_deg: number; readonly longitude_deg: number }[];
  readonly radius_m: number;
  readonly parts: readonly {
    readonly kind: "heights" | "imagery" | "vector";
    readonly name: string;
    readonly url: string;
    readonly attribution: string;
    readonly minimum_zoom: number;
    readonly maximum_zoom: number;
  }[];
}

export interface FieldState {
  /** Null until read. */
  readonly known: FieldList | null;
  /** Fields that lie in the station's folder, one layer of each. */
  readonly packs: readonly MapLayer[];
  readonly failure: Message | null;
  /** What the order that is looked at would take, or why it cannot be brought. */
  readonly estimate: FieldEstimate | Message | null;
}

export interface FieldPart {
  readonly store: StoreApi<FieldState>;
  readonly read: () => Promise<void>;
  /** Ask what an order would take; null forgets the answer. */
  readonly look: (order: FieldOrder | null) => Promise<void>;
  readonly prepare: (order: FieldOrder, asker: Asker) => Promise<void>;
  readonly pause: (id: string, asker: Asker) => Promise<void>;
  readonly resume: (id: string, asker: Asker) => Promise<void>;
  /** Stop it and delete what arrived. */
  readonly forget: (field: Pick<PreparedField, "id" | "name">, asker: Asker) => Promise<void>;
  readonly prove: (pack: Pick<MapLayer, "id" | "name">, asker: Asker) => Promise<void>;
  /** Delete a field's file for good. */
  readonly remove: (pack: Pick<MapLayer, "id" | "name">, asker: Asker) => Promise<void>;
}

export const FIELD = partName<FieldPart>("field");

const FIELDS = "/api/v1/map/fields";
export const LAYERS = "/api/v1/map/layers";
/** A proof reads all of a file, which may lie on a slow card. */
const PROOF_MS = 600_000;

/** Fields that are prepared, and those that are there. */
export function createFields(parts: RequesterParts & { readonly onChanged: () => void }): {
  readonly field: FieldPart;
  readonly takeFieldEvent: (event: StreamEvent) => void;
} {
  const { rest, onChanged } = parts;
  const { run } = createAsking(parts);
  const store = createStore<FieldState>(() => ({ known: null, packs: [], failure: null, estimate: null }));
  /** Only the answer to the newest question counts. */
  let looks = 0;

  async function read(): Promise<void> {
    const asked = rest.ask("GET", LAYERS, isMapLayers);
    const answer = await rest.ask("GET", FIELDS, isFieldList);
    store.setState(
      answer.ok
        ? { known: answer.value, failure: null }
        : { known: store.getState().known, failure: failureMessage(answer.problem) },
    );
    const layers = await asked;
    if (layers.ok) {
      store.setState({ packs: packsOf(layers.value.layers) });
    }
  }

  function note(field: PreparedField): void {
    const { known } = store.getState();
    if (known === null) return;
    const others = known.fields.filter(({ id }) => id !== field.id);
    const place = known.fields.findIndex(({ id }) => id === field.id);
    if (field.state === "removed") {
      store.setState({ known: { ...known, fields: others } });
    } else {
      const fields = place < 0 ? [...others, field] : known.fields.with(place, field);
      store.setState({ known: { ...known, fields } });
    }
  }

  function change(id: string, verb: "pause" | "resume", asker: Asker): Promise<void> {
    return run(asker, rest.ask("POST", `${FIELDS}/${id}/${verb}`, isPreparedField), (field) => {
      note(field);
      const key = verb === "pause" ? "field.saidPaused" : "field.saidResumed";
      return { state: "confirmed", message: info(key, { name: field.name }) };
    });
  }

  const field: FieldPart = {
    store,
    read,
    look: async (order) => {
      looks += 1;
      const mine = looks;
      if (order === null) {
        store.setState({ estimate: null });
        return;
      }
      const answer = await rest.ask("POST", `${FIELDS}/estimate`, isFieldEstimate, order);
      if (mine === looks) {
        store.setState({ estimate: answer.ok ? answer.value : failureMessage(answer.problem) });
      }
    },
    prepare: (order, asker) =>
      run(asker, rest.ask("POST", FIELDS, isPreparedField, { ...order, accepts_terms: true }), (begun) => {
        note(begun);
        return { state: "confirmed", message: info("field.saidBegun", { name: begun.name }) };
      }),
    pause: (id, asker) => change(id, "pause", asker),
    resume: (id, asker) => change(id, "resume", asker),
    forget: ({ id, name }, asker) =>
      run(asker, rest.ask("DELETE", `${FIELDS}/${id}`, isFieldList), (known) => {
        store.setState({ known });
        return { state: "confirmed", message: info("field.saidForgotten", { name }) };
      }),
    prove: ({ id, name }, asker) =>
      run(asker, rest.ask("POST", `${LAYERS}/${id}/proof`, isFieldProof, {}, PROOF_MS), ({ tiles }) => ({
        state: "confirmed",
        message: info("field.saidWhole", { name, tiles }),
      })),
    remove: ({ id, name }, asker) =>
      run(asker, rest.ask("DELETE", `${LAYERS}/${id}?for_good=true`, isMapLayers), ({ layers }) => {
        store.setState({ packs: packsOf(layers) });
        onChanged();
        return { state: "confirmed", message: info("field.saidRemoved", { name }) };
      }),
  };
  return {
    field,
    takeFieldEvent: ({ event, data }) => {
      if (event === "map_field") {
        note(data);
        if (data.state === "done") {
          void read();
          onChanged();
        }
      }
    },
  };
}

/** One layer of each field's file: all layers of a file have its name and size. */
function packsOf(layers: readonly MapLayer[]): readonly MapLayer[] {
  const seen = new Set<string>();
  return layers.filter(({ id, format }) => {
    const file = id.replace(/-(relief|terrain|vector)$/, "");
    const isNew = format.startsWith("field") && !seen.has(file);
    if (isNew) seen.add(file);
    return isNew;
  });
}
