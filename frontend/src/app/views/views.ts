import { useSettings } from "../../store/hooks";
import { choose, type Settings, type SettingsStore } from "../../store/settings";
import { type LazyPart, lazyPart } from "../../ui/lazyPart";

/** The main tabs in groups, in the order of work. */
export const TAB_GROUPS = [
  { name: "fly", tabs: ["fly", "flight", "six"] },
  { name: "plans", tabs: ["plans", "map"] },
  { name: "params", tabs: ["params"] },
  { name: "hil", tabs: ["hil", "hilSix", "ahrs3d"] },
  { name: "flights", tabs: ["flights", "plots"] },
  { name: "said", tabs: ["messages", "alarms"] },
  { name: "setup", tabs: ["setup"] },
] as const;
export type TabGroup = (typeof TAB_GROUPS)[number];
export type TabName = TabGroup["tabs"][number];
export const TABS: readonly TabName[] = TAB_GROUPS.flatMap(({ tabs }): readonly TabName[] => tabs);

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
export function openTabOf({ choices }: Settings): TabName {
  return TABS.find((tab) => tab === choices["tab"]) ?? "fly";
}

export function useOpenTab(): TabName {
  return useSettings(openTabOf);
}

export function groupOf(tab: TabName): TabGroup {
  return TAB_GROUPS.find(({ tabs }) => tabs.some((one) => one === tab)) ?? TAB_GROUPS[0];
}

/** The tab of a group that was last open; at first its first one. */
export function lastTabOf({ choices }: Settings, { name, tabs }: TabGroup): TabName {
  return tabs.find((tab) => tab === choices[`tab.${name}`]) ?? tabs[0];
}

/** Open a group where it was left; its next tab if it is open already. */
export function openGroup(settings: SettingsStore, group: TabGroup): void {
  const now = settings.getState();
  const open = openTabOf(now);
  const tabs: readonly TabName[] = group.tabs;
  const next = tabs[(tabs.indexOf(open) + 1) % tabs.length];
  choose(settings, "tab", tabs.includes(open) && next !== undefined ? next : lastTabOf(now, group));
}

/** Open the tab that the address names; addresses are in small letters. An unknown name changes nothing. */
export function openAddressedTab(settings: SettingsStore, named: string | null): void {
  const tab = TABS.find((known) => known.toLowerCase() === named?.toLowerCase());
  if (tab !== undefined) {
    choose(settings, "tab", tab);
  }
}

/** Calls `opened` with each main tab that is opened, and keeps it as the last one of its group. */
export function followOpenTab(settings: SettingsStore, opened: (tab: TabName) => void): void {
  settings.subscribe((now, before) => {
    const tab = openTabOf(now);
    if (tab !== openTabOf(before)) {
      for (const one of [openTabOf(before), tab]) {
        choose(settings, `tab.${groupOf(one).name}`, one);
      }
      opened(tab);
    }
  });
}
