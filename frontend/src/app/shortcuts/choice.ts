import type { Settings, SettingsStore } from "../../store/settings";
import { choose } from "../../store/settings";

/** Single keys can be switched off, for who speaks to the page or rests a hand on the keyboard. */
export function areKeysOn({ choices }: Settings): boolean {
  return choices["keys"] !== "off";
}

export function chooseKeys(store: SettingsStore, isOn: boolean): void {
  choose(store, "keys", isOn ? "on" : "off");
}
