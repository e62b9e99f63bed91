import {
  createSourceReturn,
  NOTHING_LEFT_OFF,
  SOURCE_RETURN,
  takeHeartbeats,
} from "../features/controls/sourceReturn";
import { createGamepadInput } from "../features/gamepad/gamepadInput";
import { GAMEPADS } from "../features/gamepad/gamepadList";
import { TOUCH_STICK } from "../features/gamepad/touchStick";
import { SERVO_SLIDERS } from "../features/servos/servoPositions";
import { createServoSliders } from "../features/servos/servoSliders";
import type { Batch } from "../protocol/envelope";
import type { Actions } from "../requests/actions";
import type { Core, Group } from "./core";

/** What a hand moves: the sticks and the servos' sliders, and what a change of the stick's source switched off. */
export interface Controls extends Required<Group> {
  readonly takeSamples: (samples: Batch["samples"]) => void;
  readonly start: () => void;
  readonly stop: () => void;
}

/** `send` puts on the stream what is worth nothing later. */
export function createControls(
  core: Core,
  setStick: Actions["setStick"],
  send: (text: string) => void,
): Controls {
  const { timers, vehicle, settings, tell, world } = core;
  const sourceReturn = createSourceReturn();
  const servos = createServoSliders(core);
  const { connection } = vehicle;
  const reader = world.gamepads;
  const gamepads = createGamepadInput({
    reader,
    timers,
    connection,
    settings,
    setStick,
    send,
    tell,
    report: core.fail,
  });
  return {
    addTo: (parts) =>
      parts
        .with(SOURCE_RETURN, sourceReturn)
        .with(SERVO_SLIDERS, servos.sliders)
        .with(GAMEPADS, gamepads.gamepads)
        .with(TOUCH_STICK, gamepads.touchStick),
    takeStatus: (before, status) => {
      servos.takeStatus(status);
      if (before !== null && before.board.url !== status.board.url) {
        sourceReturn.setState(NOTHING_LEFT_OFF);
      }
    },
    takeSamples: (samples) => takeHeartbeats(sourceReturn, samples),
    takeEvent: (message) => {
      servos.takeEvent(message);
      gamepads.takeEvent(message);
      if (message.event === "board_restarted") {
        // Its restart is reported on its own, with all that it switched off.
        sourceReturn.setState(NOTHING_LEFT_OFF);
      }
    },
    start: gamepads.start,
    stop: gamepads.stop,
  };
}
