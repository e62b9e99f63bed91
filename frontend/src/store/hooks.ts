import { createContext, useContext, useSyncExternalStore } from "react";
import { type StoreApi, useStore } from "zustand";
import type { MapThing } from "../lib/mapThing";
import type { Actions } from "./actions";
import type { Ahrs3d, Alignment } from "./ahrs3d";
import type { AlarmBook } from "./alarmBook";
import { type CommandEntry, type CommandStore, shown } from "./commands";
import type { Connection, ConnectionStore } from "./connection";
import type { BoardConsole, ConsoleLog } from "./console";
import type { FrameActions } from "./frame";
import type { GamepadDesk, Gamepads } from "./gamepads";
import type { Inspector } from "./inspector";
import type { MapLayerActions, MapLayers } from "./mapLayers";
import type { MapSelectionStore } from "./mapSelection";
import type { Message, MessageStore } from "./messages";
import type { ParameterActions, ParameterBook } from "./parameters";
import type { PlanActions, Plans } from "./plans";
import type { Pump } from "./pump";
import type { Servo, ServoDesk } from "./servos";
import { UNMOVED } from "./servos";
import type { Settings, SettingsStore } from "./settings";
import type { SourceReturnStore } from "./sourceReturn";
import type { TelemetryStore } from "./telemetry";
import type { TrackBook, Tracks } from "./track";

/** Everything that a component may read or ask for, put together by app. */
export interface Page {
  readonly telemetry: TelemetryStore;
  readonly pump: Pump;
  readonly connection: ConnectionStore;
  readonly commands: CommandStore;
  readonly messages: MessageStore;
  readonly settings: SettingsStore;
  readonly actions: Actions;
  readonly frame: FrameActions;
  readonly alarmBook: AlarmBook;
  readonly servos: ServoDesk;
  readonly gamepads: GamepadDesk;
  readonly boardConsole: BoardConsole;
  readonly inspector: Inspector;
  readonly parameters: ParameterActions;
  readonly missions: PlanActions;
  /** What a stay with RC as source left off. */
  readonly sourceReturn: SourceReturnStore;
  readonly ahrs3d: Ahrs3d;
  readonly mapSelection: MapSelectionStore;
  readonly mapLayers: MapLayerActions;
  readonly trackBook: TrackBook;
  /** Gives the person a file to keep. */
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

/** One thing of a slow store; the component renders again when it changes. */
function useSelected<S, T>(store: StoreApi<S>, select: (state: S) => T): T {
  return useStore(store, select);
}

export function useConnection<T>(select: (connection: Connection) => T): T {
  return useSelected(usePage().connection, select);
}

export function useSettings<T>(select: (settings: Settings) => T): T {
  return useSelected(usePage().settings, select);
}

export function usePlans<T>(select: (plans: Plans) => T): T {
  return useSelected(usePage().missions.plans, select);
}

export function useTracks<T>(select: (tracks: Tracks) => T): T {
  return useSelected(usePage().trackBook.store, select);
}

/** The gamepads of this browser; their positions are painted, see `GamepadDesk.watch`. */
export function useGamepads<T>(select: (gamepads: Gamepads) => T): T {
  return useSelected(usePage().gamepads.store, select);
}

/** What is chosen on the map. */
export function useMapThing(): MapThing | null {
  return useSelected(usePage().mapSelection, ({ thing }) => thing);
}

export function useAlignment<T>(select: (alignment: Alignment) => T): T {
  return useSelected(usePage().ahrs3d.alignment, select);
}

export function useMapLayers<T>(select: (layers: MapLayers) => T): T {
  return useSelected(usePage().mapLayers.store, select);
}

export function useParameters<T>(select: (book: ParameterBook) => T): T {
  return useSelected(usePage().parameters.book, select);
}

/**
 * One plain value out of the telemetry, looked at ten times a second: for flags and words that React shows. What
 * changes faster is painted with usePaint.
 */
export function useTelemetry<T extends string | number | boolean | null>(
  select: (telemetry: TelemetryStore, now_ms: number) => T,
): T {
  const { telemetry, pump } = usePage();
  return useSyncExternalStore(pump.onTick, () => select(telemetry, pump.now_ms));
}

/** One servo output's slider; it renders again only when it changes. */
export function useServo(index: number): Servo {
  return useSelected(usePage().servos.store, ({ servos }) => servos[index] ?? UNMOVED);
}

/** Why a servo output was not moved, while a slider shows it. */
export function useServoFailure(): Message | null {
  return useSelected(
    usePage().servos.store,
    ({ servos }) => servos.find(({ message }) => message !== null)?.message ?? null,
  );
}

/** The raw line's log, looked at ten times a second: a board that talks fast must not render for each line. */
export function useConsole(): ConsoleLog {
  const { boardConsole, pump } = usePage();
  return useSyncExternalStore(pump.onTick, () => boardConsole.store.getState());
}

/** What a control's newest command is up to, or null when there is nothing to show. */
export function useCommandEntry(control: string): CommandEntry | null {
  const { commands, pump } = usePage();
  const entries = useSelected(commands, (state) => state);
  return useSyncExternalStore(pump.onTick, () => shown(entries, control, pump.now_ms));
}
