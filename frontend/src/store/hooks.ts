import { createContext, useContext, useSyncExternalStore } from "react";
import { useStore } from "zustand";
import type { AdmissionStore } from "./admission";
import { type CommandEntry, type CommandStore, shown } from "./commands";
import type { Connection, ConnectionStore } from "./connection";
import type { MessageStore } from "./messages";
import type { PartName, Parts } from "./parts";
import type { Pump } from "./pump";
import type { Settings, SettingsStore } from "./settings";
import type { TelemetryStore } from "./telemetry";

/** All that components may read or request, assembled by app. */
export interface Page {
  readonly telemetry: TelemetryStore;
  readonly pump: Pump;
  readonly connection: ConnectionStore;
  /** Who the station takes the user for; the same for the present and the past. */
  readonly admission: AdmissionStore;
  readonly commands: CommandStore;
  readonly messages: MessageStore;
  readonly settings: SettingsStore;
  /** Each feature's own part, read only by that feature and app. */
  readonly parts: Parts;
  /** The flight of the past that these stores show; null: they show the present. */
  readonly past: string | null;
  /** Another number for each vehicle that is shown: components with a memory are made anew. */
  readonly key: number;
  /** Saves a file on the user's computer. */
  readonly saveFile: (name: string, content: Blob) => void;
}

export const PageContext = createContext<Page | null>(null);

export function usePage(): Page {
  const page = useContext(PageContext);
  if (page === null) {
    throw new Error("a component that reads the stores stands outside of PageContext");
  }
  return page;
}

/** The part of the page with this name. */
export function usePart<T>(name: PartName<T>): T {
  return usePage().parts.get(name);
}

/** Whether what is shown here is the past. */
export function useIsPast(): boolean {
  return usePage().past !== null;
}

/** One value of a slow store; the component renders again when it changes. */
export function useConnection<T>(select: (connection: Connection) => T): T {
  return useStore(usePage().connection, select);
}

export function useSettings<T>(select: (settings: Settings) => T): T {
  return useStore(usePage().settings, select);
}

/**
 * One primitive value of the telemetry, read ten times a second: for flags and words that React renders. Faster
 * values are painted with usePaint.
 */
export function useTelemetry<T extends string | number | boolean | null>(
  select: (telemetry: TelemetryStore, now_ms: number) => T,
): T {
  const { telemetry, pump } = usePage();
  return useSyncExternalStore(pump.onTick, () => select(telemetry, pump.now_ms));
}

/** The state of a control's newest command, or null if there is nothing to show. */
export function useCommandEntry(control: string): CommandEntry | null {
  const { commands, pump } = usePage();
  const entries = useStore(commands);
  return useSyncExternalStore(pump.onTick, () => shown(entries, control, pump.now_ms));
}
