import { useSettings } from "../../store/hooks";
import { choose, type SettingsStore } from "../../store/settings";
import { type LazyPart, lazyPart } from "../../ui/lazyPart";

/** The main tabs, in their order. */
export const TABS = [
  "fly",
  "flight",
  "six",
  "params",
  "hil",
  "hilSix",
  "plans",
  "map",
  "ahrs3d",
  "messages",
  "plots",
  "alarms",
  "setup",
  "flights",
] as const;
export type TabName = (typeof TABS)[number];

/** Each tab is loaded by itself, so that the first display does not wait for all of them. */
export const VIEWS: Readonly<Record<TabName, LazyPart>> = {
  fly: lazyPart(async () => (await import("../tabs/FlyTab")).FlyTab),
  flight: lazyPart(async () => (await import("../tabs/FlightTab")).FlightTab),
  six: lazyPart(async () => (await import("../../features/six/SixView")).BoardSixView),
  params: lazyPart(async () => (await import("../../features/parameters/ParamsView")).ParamsView),
  hil: lazyPart(async () => (await import("../../features/hil/HilView")).HilView),
  hilSix: lazyPart(async () => (await import("../../features/six/SixView")).HilSixView),
  plans: lazyPart(async () => (await import("../tabs/PlansTab")).PlansTab),
  map: lazyPart(async () => (await import("../../features/map/MapView")).MapView),
  ahrs3d: lazyPart(async () => (await import("../../features/ahrs/Ahrs3dView")).Ahrs3dView),
  messages: lazyPart(async () => (await import("../../features/messages/MessagesView")).MessagesView),
  plots: lazyPart(async () => (await import("../../features/plots/PlotsView")).PlotsView),
  alarms: lazyPart(async () => (await import("../../features/alarms/AlarmsView")).AlarmsView),
  setup: lazyPart(async () => (await import("../tabs/SetupTab")).SetupTab),
  flights: lazyPart(async () => (await import("../tabs/FlightsTab")).FlightsTab),
};

/** The tuning view, which stays open under any tab. */
export const TUNING = lazyPart(async () => (await import("../tabs/TuningTab")).TuningTab);

/** The stick on the screen, which stays open under any tab as well. */
export const TOUCH = lazyPart(async () => (await import("../../features/gamepad/TouchDock")).TouchDock);

/** The way in, for whom the station does not admit. */
export const ENTER_PAGE = lazyPart(async () => (await import("../../features/access/EnterPage")).EnterPage);

export async function loadViews(): Promise<void> {
  for (const { load } of [...Object.values(VIEWS), TUNING, TOUCH, ENTER_PAGE]) {
    await load();
  }
}

/** The main tab that is open: the one last chosen. */
export function useOpenTab(): TabName {
  return useSettings(({ choices }) => TABS.find((tab) => tab === choices["tab"]) ?? "fly");
}

/** Open the tab that the address names; addresses are in small letters. An unknown name changes nothing. */
export function openAddressedTab(settings: SettingsStore, named: string | null): void {
  const tab = TABS.find((known) => known.toLowerCase() === named?.toLowerCase());
  if (tab !== undefined) {
    choose(settings, "tab", tab);
  }
}
