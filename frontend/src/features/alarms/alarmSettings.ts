import { choose, type Settings, type SettingsStore } from "../../store/settings";
import type { AlarmLevel } from "./raisedAlarms";

export type AlarmChannel = "sound" | "speech";

/** What this browser does about an alarm besides showing it. */
export interface AlarmSettings {
  readonly sound: Readonly<Record<AlarmLevel, boolean>>;
  readonly speech: Readonly<Record<AlarmLevel, boolean>>;
  /** 0 is silence, 1 as loud as this machine is set. */
  readonly volume: number;
}

const DEFAULT_VOLUME = 0.5;

/** Sound is on by default, speech is off. */
export function alarmSettings({ choices }: Settings): AlarmSettings {
  const heard = (channel: AlarmChannel, level: AlarmLevel, otherwise: boolean): boolean => {
    const chosen = choices[`alarms.${channel}.${level}`];
    return chosen === undefined ? otherwise : chosen === "on";
  };
  const volume = Number(choices["alarms.volume"] ?? DEFAULT_VOLUME);
  return {
    sound: { warning: heard("sound", "warning", true), critical: heard("sound", "critical", true) },
    speech: { warning: heard("speech", "warning", false), critical: heard("speech", "critical", false) },
    volume: volume >= 0 && volume <= 1 ? volume : DEFAULT_VOLUME,
  };
}

export function chooseHeard(
  store: SettingsStore,
  channel: AlarmChannel,
  level: AlarmLevel,
  isOn: boolean,
): void {
  choose(store, `alarms.${channel}.${level}`, isOn ? "on" : "off");
}

/** Volume 0..1. */
export function chooseVolume(store: SettingsStore, volume: number): void {
  choose(store, "alarms.volume", String(volume));
}
