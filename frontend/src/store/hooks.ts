import { createContext, useContext, useSyncExternalStore } from "react";
import { type StoreApi, useStore } from "zustand";
import type { FrameActions } from "../features/about/aboutRequests";
import type { Ahrs3d, Alignment } from "../features/ahrs/alignment";
import type { AlarmBook } from "../features/alarms/alarmLog";
import type { GamepadDesk, Gamepads } from "../features/gamepad/gamepadList";
import type { MapLayerActions, MapLayers } from "../features/map/layers/layerList";
import type { MapSelectionStore } from "../features/map/mapSelection";
import type { TrackBook, Tracks } from "../features/map/trackLog";
import type { ParameterActions, ParameterBook } from "../features/parameters/parameterValues";
import type { Servo, ServoDesk } from "../features/servos/servoPositions";
import { UNMOVED } from "../features/servos/servoPositions";
import type { BoardConsole, ConsoleLog } from "../features/setup/consoleLog";
import type { MapThing } from "../lib/mapThing";
import type { PlanActions, Plans } from "../missions/planDrafts";
import type { Actions } from "./actions";
import { type CommandEntry, type CommandStore, shown } from "./commands";
import type { Connection, ConnectionStore } from "./connection";
import type { Inspector } from "./inspector";
import type { Message, MessageStore } from "./messages";
import type { Pump } from "./pump";
import type { Settings, SettingsStore } from "./settings";
import type { TelemetryStore } from "./telemetry";

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
