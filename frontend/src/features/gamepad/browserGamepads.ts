import type { GamepadReader } from "./gamepadInput";
import type { Pad } from "./stickMapping";

/** The gamepads of a real browser. It tells none before one of its buttons was pressed with the page in sight. */
export function browserGamepads(window: Window & typeof globalThis): GamepadReader {
  const { navigator, document } = window;
  return {
    read: () => {
      try {
        // Not there at all on an address that the browser does not trust; forbidden in a frame it throws.
        return (navigator.getGamepads?.() ?? []).filter((pad) => pad?.connected === true).map(padOf);
      } catch {
        return [];
      }
    },
    isInSight: () => document.visibilityState === "visible",
    onChange: (run) => {
      const events = ["gamepadconnected", "gamepaddisconnected"] as const;
      for (const event of events) {
        window.addEventListener(event, run);
      }
      return () => {
        for (const event of events) {
          window.removeEventListener(event, run);
        }
      };
    },
  };
}

function padOf(pad: Gamepad | null): Pad {
  const { id = "", index = 0, mapping = "", axes = [], buttons = [] } = pad ?? {};
  return {
    id,
    index,
    isStandard: mapping === "standard",
    axes: [...axes],
    buttons: buttons.map(({ value }) => value),
  };
}
