import { choose, type SettingsStore } from "../store/settings";
import { TABS } from "./views";

/** Open the tab that the address names; addresses are in small letters. An unknown name changes nothing. */
export function openAddressedTab(settings: SettingsStore, named: string | null): void {
  const tab = TABS.find((known) => known.toLowerCase() === named?.toLowerCase());
  if (tab !== undefined) {
    choose(settings, "tab", tab);
  }
}
