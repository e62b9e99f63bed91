import type { CommandName } from "../protocol/messages.gen";
import type { Message } from "./messages";

/** A way in to the board, as the gateway found it. */
export interface Port {
  readonly device: string;
  readonly description: string;
}

export interface SimulatorLink {
  readonly receive_port: number;
  readonly send_host: string;
  readonly send_port: number;
  readonly profile: "xp10" | "xp12";
}

/** Which control asked, so that it can show what becomes of it; `asked` is the position that it shall take. */
export interface Asker {
  readonly control: string;
  readonly asked?: string;
}

/** Arguments of a command: one number, or several by name. */
export type CommandValue = number | Readonly<Record<string, number>>;

/**
 * What a person can ask of the gateway. Each writes its progress into the command store under the asker's name and
 * its outcome into the messages; none throws, and the promise only says that it is over.
 */
export interface Actions {
  readonly command: (name: CommandName, asker: Asker, value?: CommandValue) => Promise<void>;
  readonly setHil: (
    change: { readonly source: "joystick" | "rc" } | { readonly path: "manual" | "assisted" },
    asker: Asker,
  ) => Promise<void>;
  /** Where the pilot's stick comes from: the simulator, or this page's gamepad by its name. */
  readonly setStick: (
    change: { readonly stick: "simulator" } | { readonly stick: "gamepad"; readonly gamepad: string },
    asker: Asker,
  ) => Promise<void>;
  readonly openBoard: (url: string, asker: Asker) => Promise<void>;
  readonly closeBoard: (asker: Asker) => Promise<void>;
  readonly openSimulator: (link: SimulatorLink, asker: Asker) => Promise<void>;
  readonly closeSimulator: (asker: Asker) => Promise<void>;
  readonly takeControl: (asker: Asker) => Promise<void>;
  readonly releaseControl: (asker: Asker) => Promise<void>;
  /** The ports, or the sentence that says why there is no list. */
  readonly listPorts: () => Promise<readonly Port[] | Message>;
}
