import type { GamepadReader } from "./gamepadList";
import type { Pad } from "./stickMapping";

/** The browser's gamepads. It hides each until one of its buttons was pressed while the page was visible. */
export function browserGamepads(window: Window & typeof globalThis): GamepadReader {
  const { navigator, document } = window;
  return {
    read: () => {
      try {
        // Undefined on an insecure address; throws in an iframe that may not use it.
        return (navigator.getGamepads?.() ?? []).filter((pad) => pad?.connected === true).map(padOf);
      } catch {
        return [];
      }
    },
    isInSight: () => document.visibilityState === "visible",
    onChange: (run) => {
      const connected = ({ gamepad }: Partial<GamepadEvent>): void => run(gamepad?.index);
      const disconnected = (): void => run();
      window.addEventListener("gamepadconnected", connected);
      window.addEventListener("gamepaddisconnected", disconnected);
      return () => {
        window.removeEventListener("gamepadconnected", connected);
        window.removeEventListener("gamepaddisconnected", disconnected);
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
