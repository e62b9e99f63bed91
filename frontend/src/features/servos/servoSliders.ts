import { Repeating } from "../../lib/repeating";
import type { Timers } from "../../lib/timers";
import type { Status } from "../../protocol/contract";
import type { StreamEvent } from "../../protocol/envelope";
import { isCommandOutcome } from "../../protocol/guards.gen";
import { resultMessage } from "../../requests/actions";
import type { Gateway } from "../../requests/asking";
import type { Outcome } from "../../store/commands";
import { failureMessage, type Message } from "../../store/messages";
import {
  createServos,
  DRIVEN_SERVOS,
  forgetServos,
  SERVO_COUNT,
  type ServoSliders,
  setServo,
} from "./servoPositions";

/** Shortest time between moves: twenty a second take a quarter of the capacity of the slowest usual link. */
const PERIOD_MS = 50;

interface Parts {
  readonly rest: Gateway;
  readonly timers: Timers;
  readonly client: () => string | null;
  readonly tell: (message: Message) => void;
}

export interface ServoSlidersEnds {
  readonly sliders: ServoSliders;
  /** Handles another browser's moves, and commands that make the servos' positions unknown. */
  readonly takeEvent: (event: StreamEvent) => void;
  readonly takeStatus: (status: Status) => void;
  /** No position is known any more. */
  readonly forget: () => void;
}

/** What makes the positions of the driven servos unknown. */
const MODES: ReadonlySet<string> = new Set(["servos_control_mode_fly_by_wire", "servos_control_mode_hil"]);

/** Sends the sliders' positions: one move per servo at a time, then its newest position. */
export function createServoSliders({ rest, timers, client, tell }: Parts): ServoSlidersEnds {
  const store = createServos();
  const wanted = new Map<number, number>();
  const underWay = new Set<number>();
  const moves = new Repeating(timers, moveNext, PERIOD_MS);
  let board = "";

  function sendNext(): void {
    if (!moves.isArmed) {
      moves.run();
    }
  }

  function moveNext(): number | null {
    const next = [...wanted].find(([servo]) => !underWay.has(servo));
    if (next === undefined) {
      return null;
    }
    const [servo, position] = next;
    wanted.delete(servo);
    underWay.add(servo);
    void send(servo, position);
    return PERIOD_MS;
  }

  async function send(servo: number, position: number): Promise<void> {
    const value = { servo, position };
    const answer = await rest.ask("POST", "/api/v1/commands/servo_out", isCommandOutcome, { value });
    underWay.delete(servo);
    if (!wanted.has(servo)) {
      const state = answer.ok ? answer.value.state : "rejected";
      const message = answer.ok
        ? resultMessage("@command.servo_out", answer.value)
        : failureMessage(answer.problem);
      settle(servo, position, state, message);
    }
    sendNext();
  }

  function settle(servo: number, position: number, state: Outcome, message: Message): void {
    if (state === "confirmed" || state === "sent") {
      setServo(store, servo, { position, state, message: null });
      return;
    }
    // Refused or lost: the servo's position is unknown.
    setServo(store, servo, { position: null, state, message });
    tell(message);
  }

  return {
    sliders: {
      store,
      move: (servo, position) => {
        if (servo < 0 || servo >= SERVO_COUNT) {
          return;
        }
        setServo(store, servo, { position, state: "pending", message: null });
        wanted.set(servo, position);
        sendNext();
      },
    },
    takeEvent: ({ event, data }) => {
      if (event !== "command" || (data.state !== "confirmed" && data.state !== "sent")) {
        return;
      }
      const { name, state } = data;
      if (name === "servo_out" && data.client !== client()) {
        const [servo = -1, position = 0] = data.value;
        setServo(store, servo, { position, state, message: null });
      } else if (MODES.has(name)) {
        forgetServos(store, DRIVEN_SERVOS);
      } else if (name === "reset") {
        forgetServos(store);
      }
    },
    forget: () => forgetServos(store),
    takeStatus: ({ board: { state, url, reopened } }) => {
      const now = `${state} ${url} ${reopened}`;
      if (now !== board) {
        board = now;
        wanted.clear();
        forgetServos(store);
      }
    },
  };
}
