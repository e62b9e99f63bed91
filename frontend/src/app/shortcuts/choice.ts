import type { Settings, SettingsStore } from "../../store/settings";
import { choose } from "../../store/settings";

/** Single-key shortcuts can be switched off, for people who use speech input or rest a hand on the keyboard. */
export function areKeysOn({ choices }: Settings): boolean {
  return choices["keys"] !== "off";
}

export function chooseKeys(store: SettingsStore, isOn: boolean): void {
  choose(store, "keys", isOn ? "on" : "off");
}
