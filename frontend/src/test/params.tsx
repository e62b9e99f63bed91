import { screen, within } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { ParamsView } from "../features/parameters/ParamsView";
import type { GainState, OwnGains, ParameterList } from "../protocol/guards.gen";
import { PARAMETERS, type ParameterName } from "../protocol/messages.gen";
import { WORDS } from "../ui/test/testWords";
import { WordsProvider } from "../ui/words";
import { aStatus } from "./aStatus";
import { type FakeRequest, Station } from "./station";

export const user = userEvent.setup();
export let station: Station;

export type GainStates = Partial<Record<ParameterName, Partial<GainState>>>;

/** A board that does not describe itself. */
const NO_OWN_GAINS: OwnGains = {
  table: { state: "none", blocks_read: 0, block_count: 0, gains: [], topics: [], left_out: [] },
  values: {},
};

/** The gateway's list when the board has its defaults except for these. */
export function listed(known: GainStates = {}, own: OwnGains = NO_OWN_GAINS): ParameterList {
  return {
    own,
    parameters: PARAMETERS.map(({ setId, isInteger, ...info }) => ({
      ...info,
      is_integer: isInteger,
      unit: "",
      value: info.default,
      loaded: info.default,
      state: "loaded",
      ...known[info.name],
    })),
  };
}

export const unknown = Object.fromEntries(
  PARAMETERS.map(({ name }) => [name, { value: null, loaded: null, state: "unknown" }]),
) as GainStates;

export function newest(method: string, path: RegExp): FakeRequest {
  const asked = station.asked
    .filter((question) => question.method === method && path.test(question.path))
    .at(-1);
  if (asked === undefined) {
    throw new Error(`the page asked nothing with ${method} ${path}`);
  }
  return asked;
}

export function writes(): unknown[] {
  return station.asked.filter(({ method }) => method !== "GET").map(({ path, body }) => body ?? path);
}

/** The view alone, with a gateway that knows this. */
export async function open(known: GainStates = {}, status = aStatus()): Promise<void> {
  openUnanswered(status);
  await answer(known);
}

/** The view alone, whose questions at its opening wait for their answer. */
export function openUnanswered(status = aStatus()): void {
  station = new Station(
    <WordsProvider words={WORDS}>
      <ParamsView />
    </WordsProvider>,
  );
  station.greet(status);
}

/** The whole page with this tab open. */
export async function openPage(): Promise<void> {
  station = new Station();
  station.greet();
  await user.click(screen.getByRole("tab", { name: "Autopilot Param" }));
  await answer({});
}

/** Answers the questions of an opening. */
export async function answer(known: GainStates, own?: OwnGains): Promise<void> {
  await newest("GET", /parameters$/).answer(listed(known, own));
  await newest("GET", /journal$/).answer({ entries: [], undo: null, redo: null });
}

export function field(name: string): HTMLInputElement {
  return within(row(name)).getByRole("textbox", { name });
}

export function row(name: string): HTMLElement {
  const found = document.querySelector<HTMLElement>(`[data-parameter="${name}"]`);
  if (found === null) throw new Error(`there is no row for ${name}`);
  return found;
}

export async function type(name: string, text: string): Promise<void> {
  await user.clear(field(name));
  await user.type(field(name), text);
}
