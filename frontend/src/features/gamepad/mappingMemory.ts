import { isFlag, isNumber, isObject, isText } from "../../lib/check";
import { choose, type SettingsStore } from "../../store/settings";
import {
  type AxisMapping,
  MAX_DEAD_ZONE,
  type PadInput,
  STICK_AXES,
  type StickMapping,
} from "./stickMapping";

const nameOf = (id: string): string => `gamepad.${id}`;

/** The stored mapping for gamepads of this name; null if there is none or it is unreadable. */
export function rememberedMapping(settings: SettingsStore, id: string): StickMapping | null {
  const kept = settings.getState().choices[nameOf(id)];
  if (kept === undefined) {
    return null;
  }
  try {
    const value: unknown = JSON.parse(kept);
    return isMapping(value) ? value : null;
  } catch {
    return null;
  }
}

export function rememberMapping(settings: SettingsStore, id: string, mapping: StickMapping): void {
  choose(settings, nameOf(id), JSON.stringify(mapping));
}

function isMapping(value: unknown): value is StickMapping {
  return isObject(value) && STICK_AXES.every((axis) => isAxisMapping(value[axis]));
}

function isAxisMapping(value: unknown): value is AxisMapping {
  return (
    isObject(value) &&
    (value["input"] === null || isInput(value["input"])) &&
    isFlag(value["isInverted"]) &&
    isFlag(value["springs"]) &&
    isNumber(value["deadZone"]) &&
    value["deadZone"] >= 0 &&
    value["deadZone"] <= MAX_DEAD_ZONE &&
    isNumber(value["rest"]) &&
    Math.abs(value["rest"]) < 1
  );
}

function isInput(value: unknown): value is PadInput {
  return isText(value) && /^[ab]\d{1,3}$/.test(value);
}
