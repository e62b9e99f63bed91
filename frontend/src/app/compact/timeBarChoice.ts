import { choose, type Settings, type SettingsStore } from "../../store/settings";

const NAME = "timeBar";

/** Whether a small window shows the time bar in the present too; in the past it always does. */
export function isTimeBarShown({ choices }: Settings): boolean {
  return choices[NAME] === "shown";
}

export function chooseTimeBar(settings: SettingsStore, isShown: boolean): void {
  choose(settings, NAME, isShown ? "shown" : "folded");
}
