import type { StreamEvent } from "../../protocol/envelope";
import type { GainState } from "../../protocol/guards.gen";
import {
  isCommandOutcome,
  isParameterJournal,
  isParameterList,
  type ParameterList,
} from "../../protocol/guards.gen";
import type { ParameterName } from "../../protocol/messages.gen";
import { isParameterName } from "../../protocol/parameterName";
import { resultMessage } from "../../requests/actions";
import type { Asker } from "../../requests/asking";
import { createAsking, info, type RequestEnd, type RequesterParts } from "../../requests/asking";
import { failureMessage, type Message } from "../../store/messages";
import {
  type Changes,
  type ParameterActions,
  type ParameterStore,
  take,
  takeEntry,
  takeJournal,
  takeOwn,
  takeStored,
} from "./parameterValues";

const PATH = "/api/v1/parameters";

/** The requests about the gains, with their outcome in the stores. */
export function createParameterActions(values: ParameterStore, parts: RequesterParts): ParameterActions {
  const { rest, wall_ms } = parts;
  const { run } = createAsking(parts);
  /** Edits under way, each with the newest request that waits for its end. */
  const underWay = new Map<string, number | null>();

  function takeList({ parameters, own }: ParameterList): void {
    takeOwn(values, own);
    take(values, Object.fromEntries(parameters.map(({ name, ...held }) => [name, held])));
  }

  /** A request whose answer has all the gains; returns the message of a failure, or null. */
  async function ask(
    question: readonly ["POST" | "PATCH", string, object?],
    asker: Asker,
    end: (listed: ParameterList) => RequestEnd,
  ): Promise<Message | null> {
    const [method, path, body] = question;
    const asked = rest.ask(method, path, isParameterList, body);
    await run(asker, asked, (listed) => {
      takeList(listed);
      return end(listed);
    });
    const answer = await asked;
    return answer.ok ? null : failureMessage(answer.problem);
  }

  function write(changes: Changes, asker: Asker): Promise<Message | null> {
    return ask(["PATCH", PATH, changes], asker, (listed) => writtenEnd(changes, listed));
  }

  async function move(kind: "undo" | "redo", asker: Asker): Promise<void> {
    const moves = values.getState().journal?.[kind] ?? [];
    const changes: Changes = Object.fromEntries(moves.map(({ name, after }) => [name, after]));
    await ask(["POST", `${PATH}/${kind}`], asker, (listed) => writtenEnd(changes, listed));
  }

  async function refresh(): Promise<void> {
    const before = values.getState();
    const [listed, journal] = await Promise.all([
      rest.ask("GET", PATH, isParameterList),
      rest.ask("GET", `${PATH}/journal`, isParameterJournal),
    ]);
    if (values.getState() !== before) {
      // What came meanwhile is newer than these answers, and perhaps of some gains alone.
      await refresh();
      return;
    }
    if (listed.ok) takeList(listed.value);
    if (journal.ok) takeJournal(values, journal.value);
  }

  return {
    values,
    write,

    refresh,

    load: async (asker) => {
      await ask(["POST", `${PATH}/load`], asker, () => ({
        state: "confirmed",
        message: info("params.saidLoaded"),
      }));
    },

    edit: async (name, value) => {
      if (underWay.has(name)) {
        underWay.set(name, value);
        return;
      }
      for (let wish: number | null = value; wish !== null; wish = underWay.get(name) ?? null) {
        underWay.set(name, null);
        await write({ [name]: wish }, { control: `parameter.${name}` });
      }
      underWay.delete(name);
    },

    undo: (asker) => move("undo", asker),
    redo: (asker) => move("redo", asker),

    store: (asker) =>
      run(asker, rest.ask("POST", `${PATH}/store`, isCommandOutcome), (result) => {
        if (result.state !== "confirmed") {
          return { state: result.state, message: resultMessage("@command.store_parameters", result) };
        }
        takeStored(values, wall_ms());
        return { state: "confirmed", message: info("params.saidStored") };
      }),
  };
}

/** The outcome of a step, from the gains that were read back. */
function writtenEnd(changes: Changes, { parameters, own }: ParameterList): RequestEnd {
  const ofBoard = Object.entries(own.values).map(([name, held]) => ({ name, ...held }));
  const written = [...parameters, ...ofBoard].filter(({ name }) => changes[name] !== undefined);
  const choices = new Map(own.table.gains.map(({ name, choices }) => [name, choices]));
  const say = (name: string, value: number | null | undefined): string | number | null =>
    value == null ? null : (choices.get(name)?.[value] ?? value);
  const refused = written.filter(({ state }) => state !== "confirmed");
  const [first] = refused;
  if (first !== undefined) {
    return {
      state: "rejected",
      message: {
        level: "error",
        key: "params.saidRefused",
        params: {
          names: refused.map(({ name }) => name).join(", "),
          wanted: say(first.name, changes[first.name]) ?? "",
          value: say(first.name, first.value) ?? "@words.unknown",
        },
      },
    };
  }
  const what = written.map(({ name, value }) => `${name} = ${say(name, value) ?? ""}`).join(", ");
  return { state: "confirmed", message: info("params.saidWritten", { what }) };
}

/** Handle the stream's events about the gains, whoever caused them. */
export function takeParameterEvent(
  values: ParameterStore,
  { event, data }: StreamEvent,
  wall_ms: number,
): void {
  if (event === "parameter") {
    const news: Partial<Record<ParameterName, GainState>> = {};
    for (const [name, held] of Object.entries(data.parameters)) {
      if (isParameterName(name)) {
        news[name] = held;
      }
    }
    take(values, news);
  } else if (event === "own_gains") {
    takeOwn(values, data);
  } else if (event === "journal") {
    takeEntry(values, data);
  } else if (event === "command" && data.name === "store_parameters" && data.state === "confirmed") {
    takeStored(values, wall_ms);
  }
}
