import { GuardedCalls } from "../../lib/guardedCalls";
import { Repeating } from "../../lib/repeating";
import type { Timers } from "../../lib/timers";
import type { StreamEvent } from "../../protocol/envelope";
import type { StickEvent } from "../../protocol/guards.gen";
import type { Actions } from "../../requests/actions";
import type { ConnectionStore } from "../../store/connection";
import type { Message } from "../../store/messages";
import type { SettingsStore } from "../../store/settings";
import {
  type AxisPositions,
  createGamepads,
  type GamepadInput,
  type GamepadReader,
  type PadName,
} from "./gamepadList";
import { rememberedMapping, rememberMapping } from "./mappingMemory";
import { MovedAxes } from "./movedAxes";
import {
  assigned,
  atRest,
  axisPosition,
  defaultMapping,
  movedInput,
  type Pad,
  type StickAxis,
  type StickMapping,
  stickPosition,
} from "./stickMapping";
import { createTouchStick, type TouchStick, withTouchStick } from "./touchStick";

interface Parts {
  readonly reader: GamepadReader;
  readonly timers: Timers;
  readonly connection: ConnectionStore;
  readonly settings: SettingsStore;
  readonly setStick: Actions["setStick"];
  readonly send: (text: string) => void;
  readonly tell: (message: Message) => void;
  /** Hears once of each painter that throws, and of each run of steps that fail. */
  readonly report: (error: unknown) => void;
}

/** 50 Hz while somebody watches or flies, else only a check for gamepads. */
const SAMPLE_EVERY_MS = 20;
const SEARCH_EVERY_MS = 500;
const DECIMALS = 1e4;

const NOWHERE: AxisPositions = { elevator: null, aileron: null, rudder: null, throttle: null };

/** Reads the gamepads, maps the selected one, and sends its position while it flies. */
export function createGamepadInput(parts: Parts): {
  readonly gamepads: GamepadInput;
  readonly touchStick: TouchStick;
  readonly takeEvent: (event: StreamEvent) => void;
  readonly start: () => void;
  readonly stop: () => void;
} {
  const { timers, connection, settings } = parts;
  const touch = createTouchStick();
  const reader = withTouchStick(parts.reader, touch.reader);
  const store = createGamepads();
  const watchers = new Set<(positions: AxisPositions) => void>();
  let cancelEvents: () => void = () => undefined;
  const movedAxes = new MovedAxes();
  let before: Pad | null = null;
  let asking = 0;
  const calls = new GuardedCalls(parts.report);
  const steps = new Repeating({ ...timers, report: parts.report }, step, SAMPLE_EVERY_MS);

  /** Whether the gateway uses this page's gamepad as the stick. */
  function flies(): boolean {
    const { phase, status, client } = connection.getState();
    return phase === "open" && client !== null && status?.hil.stick?.client === client;
  }

  function mappingOf(pad: Pad): StickMapping {
    return pad.mapping ?? rememberedMapping(settings, pad.id) ?? defaultMapping(pad);
  }

  /** The selected gamepad if it is connected. Another one replaces it only while none flies. */
  function choosePad(pads: readonly Pad[]): Pad | null {
    const { selected } = store.getState();
    const flown = flies() ? connection.getState().status?.hil.stick?.gamepad : null;
    const wanted = selected?.id ?? flown;
    const same = pads.filter(({ id }) => id === wanted);
    const found = same.find(({ index }) => index === selected?.index) ?? same[0];
    return found ?? (flies() ? null : (pads[0] ?? null));
  }

  function look(): Pad | null {
    const pads = reader.read();
    movedAxes.follow(pads);
    const pad = choosePad(pads);
    const { pads: known, selected } = store.getState();
    if (!isSameList(known, pads)) {
      store.setState({ pads: pads.map(({ id, index }) => ({ id, index })) });
    }
    if (pad === null) {
      // The gamepad that flew stays selected: only the same one may fly on when it is connected again.
      if (store.getState().mapping !== null) {
        store.setState({ mapping: null, assigning: null, ...(flies() ? {} : { selected: null }) });
      }
    } else if (store.getState().mapping === null || !isSame(selected, pad)) {
      store.setState({
        selected: { id: pad.id, index: pad.index },
        mapping: mappingOf(pad),
        assigning: null,
      });
    }
    return pad;
  }

  /** The axes that must move before this gamepad is the stick; said once if it flies. */
  function awaitAxes(axes: readonly StickAxis[]): void {
    const { awaited } = store.getState();
    if (axes.length === awaited.length && axes.every((axis, place) => axis === awaited[place])) {
      return;
    }
    store.setState({ awaited: axes });
    if (awaited.length === 0 && flies()) {
      const { selected } = store.getState();
      parts.tell({
        level: "warning",
        key: "gamepad.awaitedInFlight",
        params: { gamepad: selected?.id ?? "" },
      });
    }
  }

  function keep(mapping: StickMapping): void {
    const { selected } = store.getState();
    if (selected !== null) {
      store.setState({ mapping });
      rememberMapping(settings, selected.id, mapping);
    }
  }

  function waitForMove(pad: Pad, mapping: StickMapping): void {
    const { assigning } = store.getState();
    if (assigning === null) {
      before = null;
      return;
    }
    before ??= pad;
    const input = movedInput(before, pad, assigning);
    if (input !== null) {
      keep(assigned(mapping, assigning, input, before, pad));
      store.setState({ assigning: null });
      before = null;
    }
  }

  function send(pad: Pad, mapping: StickMapping): void {
    const position = stickPosition(pad, mapping);
    if (position !== null && reader.isInSight()) {
      const rounded = Object.entries(position).map(([axis, value]) => [
        axis,
        Math.round(value * DECIMALS) / DECIMALS,
      ]);
      const sample = { type: "stick", ...Object.fromEntries(rounded), t_ms: timers.now_ms() };
      parts.send(JSON.stringify(sample));
    }
  }

  function work(pad: Pad, mapping: StickMapping): AxisPositions {
    waitForMove(pad, mapping);
    const current = store.getState().mapping ?? mapping;
    awaitAxes(movedAxes.awaited(pad, current));
    if ((asking > 0 || flies()) && store.getState().awaited.length === 0) {
      send(pad, current);
    }
    return positionsOf(pad, current);
  }

  function read(): AxisPositions {
    const pad = look();
    const { mapping } = store.getState();
    if (pad === null || mapping === null) {
      awaitAxes([]);
      return NOWHERE;
    }
    return work(pad, mapping);
  }

  /** Whatever one step throws, the next one comes: the stick must not stop because a bar could not be painted. */
  function step(): number {
    let positions = NOWHERE;
    try {
      positions = read();
    } finally {
      calls.each(watchers, (paint) => paint(positions));
    }
    const isBusy = watchers.size > 0 || asking > 0 || flies();
    return isBusy ? SAMPLE_EVERY_MS : SEARCH_EVERY_MS;
  }

  function now(): void {
    steps.run();
  }

  const gamepads: GamepadInput = {
    store,
    watch: (paint) => {
      watchers.add(paint);
      now();
      return () => watchers.delete(paint);
    },
    select: (pad) => {
      store.setState({ selected: pad, mapping: null, assigning: null });
      now();
    },
    change: (axis, change) => {
      const { mapping } = store.getState();
      if (mapping !== null) {
        keep({ ...mapping, [axis]: { ...mapping[axis], ...change } });
      }
    },
    assign: (axis) => {
      before = null;
      store.setState({ assigning: axis });
    },
    centre: () => {
      const { mapping } = store.getState();
      const pad = look();
      if (mapping !== null && pad !== null && pad.mapping === undefined) {
        keep(atRest(mapping, pad));
      }
    },
    reset: () => {
      const pad = look();
      if (pad !== null && pad.mapping === undefined) {
        keep(defaultMapping(pad));
      }
    },
    agree: () => {
      const pad = look();
      if (pad !== null) {
        movedAxes.agree(pad);
        now();
      }
    },
    fly: async (asker) => {
      const { selected } = store.getState();
      if (selected === null) {
        return;
      }
      asking += 1;
      now();
      await parts.setStick({ stick: "gamepad", gamepad: selected.id }, asker);
      // Until the next status confirms it.
      timers.after(1000, () => {
        asking -= 1;
      });
    },
    flySimulator: (asker) => parts.setStick({ stick: "simulator" }, asker),
  };

  return {
    gamepads,
    touchStick: touch.stick,
    takeEvent: ({ event, data }) => {
      const message = event === "stick" ? messageOf(data, connection.getState().client) : null;
      if (message !== null) {
        parts.tell(message);
      }
    },
    start: () => {
      cancelEvents = reader.onChange((connected) => {
        if (connected !== undefined) {
          movedAxes.connected(connected);
        }
        now();
      });
      now();
    },
    stop: () => {
      cancelEvents();
      steps.cancel();
    },
  };
}

/**
 * The message for an event; null if this page reports it as the outcome of its own request, or if there is nothing to
 * say.
 */
function messageOf(event: StickEvent, ownClient: string | null): Message | null {
  const { reason, source, client, name, gamepad } = event;
  if (reason === "chosen" && client !== null && client === ownClient) {
    return null;
  }
  const chosen = source === "gamepad" ? "other" : "simulator";
  return {
    level: reason === "lost" || reason === "control_lost" ? "warning" : "info",
    key: `stickSaid.${reason === "chosen" ? chosen : reason}`,
    params: { gamepad: gamepad ?? "", name: name ?? "" },
  };
}

function positionsOf(pad: Pad, mapping: StickMapping): AxisPositions {
  const of = (axis: StickAxis): number | null => axisPosition(pad, axis, mapping[axis]);
  return {
    elevator: of("elevator"),
    aileron: of("aileron"),
    rudder: of("rudder"),
    throttle: of("throttle"),
  };
}

function isSame(first: PadName | null, second: PadName): boolean {
  return first?.id === second.id && first.index === second.index;
}

function isSameList(first: readonly PadName[], second: readonly PadName[]): boolean {
  return (
    first.length === second.length && first.every((one, place) => second[place] && isSame(one, second[place]))
  );
}
