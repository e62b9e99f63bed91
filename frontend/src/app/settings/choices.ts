import { choose, type Settings, type SettingsStore } from "../../store/settings";

/** `system`: as the operating system asks. `less`: always reduced motion. */
export const MOTION = ["system", "less"] as const;
export type Motion = (typeof MOTION)[number];

export function motionOf({ choices }: Settings): Motion {
  return MOTION.find((motion) => motion === choices["motion"]) ?? "system";
}

/** Single-key shortcuts can be switched off, for people who use speech input or rest a hand on the keyboard. */
export function areKeysOn({ choices }: Settings): boolean {
  return choices["keys"] !== "off";
}

export function chooseKeys(store: SettingsStore, isOn: boolean): void {
  choose(store, "keys", isOn ? "on" : "off");
}

const TIME_BAR = "timeBar";

/** Whether a small window shows the time bar in the present too; in the past it always does. */
export function isTimeBarShown({ choices }: Settings): boolean {
  return choices[TIME_BAR] === "shown";
}

export function chooseTimeBar(settings: SettingsStore, isShown: boolean): void {
  choose(settings, TIME_BAR, isShown ? "shown" : "folded");
}
