import { createStore, type StoreApi } from "zustand/vanilla";
import type { StreamEvent } from "../../protocol/envelope";
import type { AlarmBook, ThresholdList } from "../../protocol/guards.gen";
import type { Asker } from "../../requests/asking";
import type { Message } from "../../store/messages";
import { partName } from "../../store/parts";
import type { Language } from "../../store/settings";
import type { EndedAlarm } from "./endedAlarms";
import { type AlarmLevel, BOARD_RESTARTED, type BoardRestart, type OwnAlarm } from "./raisedAlarms";

export type PastAlarm = AlarmBook["past"][number];
export type Threshold = ThresholdList["thresholds"][number];
export type BatteryPack = NonNullable<ThresholdList["battery"]>;

/** `waits`: the browser needs a user gesture first. `none`: it cannot play sound. */
export type SounderState = "ready" | "waits" | "none";

/** Makes the alarms' tones. */
export interface Sounder {
  readonly state: () => SounderState;
  /** Volume 0..1. Stops a signal that is still playing. */
  readonly play: (level: AlarmLevel, volume: number) => void;
  readonly hush: () => void;
  readonly onState: (changed: () => void) => void;
}

/** `foreign`: there are voices, but none for this language. */
export type SpeakerState = SounderState | "foreign";

/** Speaks sentences. */
export interface Speaker {
  readonly state: (language: Language) => SpeakerState;
  /**
   * Replaces what is being spoken: there is never a queue. Volume 0..1. `told` hears whether the voice has begun; a
   * sentence that is replaced before that is not told.
   */
  readonly say: (text: string, language: Language, volume: number, told: (isHeard: boolean) => void) => void;
  readonly hush: () => void;
  readonly onState: (changed: () => void) => void;
}

/** How long `mute` lasts. */
export const MUTE_MS = 120_000;
/** How many of the page's own past alarms are kept. */
const OWN_PAST_MOST = 50;

export interface AlarmLogState {
  /** The page's own alarm, that it does not hear the gateway; null while it does. */
  readonly own: OwnAlarm | null;
  /** The board restarted and nobody has acknowledged it yet; the newest restart. */
  readonly restart: BoardRestart | null;
  /** The page's own alarm that ended unacknowledged; null if there is none. */
  readonly ownEnded: EndedAlarm | null;
  /** The page's own past alarms, newest first. */
  readonly ownPast: readonly PastAlarm[];
  /** The gateway's past alarms, newest first; null until read. */
  readonly past: readonly PastAlarm[] | null;
  readonly thresholds: readonly Threshold[] | null;
  /** What the battery's alarm goes by; null until a voltage was measured. */
  readonly battery: BatteryPack | null;
  /** Why the list or the thresholds could not be read. */
  readonly failure: Message | null;
  /** Counts the gateway's reports that an alarm was raised or ended: when it changes, the list is out of date. */
  readonly reported: number;
  /** End of the mute, milliseconds of the page's clock; null while not muted. */
  readonly mutedUntil_ms: number | null;
  readonly sounder: SounderState;
  /** By language. */
  readonly speaker: Readonly<Record<Language, SpeakerState>>;
}

export type AlarmLogStore = StoreApi<AlarmLogState>;

export function createAlarmLogStore(): AlarmLogStore {
  return createStore<AlarmLogState>(() => ({
    own: null,
    restart: null,
    ownEnded: null,
    ownPast: [],
    past: null,
    thresholds: null,
    battery: null,
    failure: null,
    reported: 0,
    mutedUntil_ms: null,
    sounder: "none",
    speaker: { es: "none", en: "none" },
  }));
}

/** Most gains that the alarm names. */
const NAMED = 4;

/** Handle the stream's events about alarms: one was raised or ended, or the board restarted. */
export function takeAlarmEvent(store: AlarmLogStore, { event, data, t_s }: StreamEvent): void {
  if (event === "alarm") {
    store.setState(({ reported }) => ({ reported: reported + 1 }));
  } else if (event === BOARD_RESTARTED) {
    const { parameters, plans } = data;
    const more = parameters.length > NAMED ? "…" : "";
    const gains = `${parameters.slice(0, NAMED).join(", ")}${more}`;
    const lost = `@lostPlans.${plans.length > 1 ? "both" : (plans[0] ?? "both")}`;
    store.setState({
      restart: {
        since_s: t_s,
        params: { ...(gains === "" ? {} : { gains }), ...(plans.length === 0 ? {} : { plans: lost }) },
      },
    });
  }
}

/** The page was shut out, which is no loss of the station: nothing rings, and nothing is left to acknowledge. */
export function forgetOwnAlarm(store: AlarmLogStore): void {
  store.setState({ own: null, ownEnded: null });
}

/** The page's own alarm was raised (Unix seconds). */
export function raiseOwn(store: AlarmLogStore, since_s: number): void {
  store.setState(({ own }) => ({ own: own ?? { since_s, acknowledged: false }, ownEnded: null }));
}

/** The page's own alarm ended (Unix seconds) and joins the past ones. */
export function endOwn(store: AlarmLogStore, until_s: number, alarm: Pick<PastAlarm, "id" | "text">): void {
  store.setState(({ own, ownPast }) =>
    own === null
      ? {}
      : {
          own: null,
          ownEnded: own.acknowledged ? null : { ...alarm, level: "critical" as const, until_s, count: 1 },
          ownPast: [
            { ...alarm, ...own, level: "critical" as const, params: {}, until_s },
            ...ownPast.slice(0, OWN_PAST_MOST - 1),
          ],
        },
  );
}

/** Acknowledge the page's own alarm, active or ended. */
export function acknowledgeOwn(store: AlarmLogStore): void {
  store.setState(({ own, ownEnded, ownPast }) => ({
    own: own && { ...own, acknowledged: true },
    ownEnded: null,
    ownPast: ownPast.map((alarm) =>
      alarm.id === ownEnded?.id && alarm.until_s === ownEnded.until_s
        ? { ...alarm, acknowledged: true }
        : alarm,
    ),
  }));
}

/** The board's restart was acknowledged (Unix seconds): it joins the past alarms. */
export function endRestart(store: AlarmLogStore, until_s: number): void {
  store.setState(({ restart, ownPast }) =>
    restart === null
      ? {}
      : {
          restart: null,
          ownPast: [
            {
              ...restart,
              id: BOARD_RESTARTED,
              text: "The board restarted.",
              level: "critical" as const,
              acknowledged: true,
              until_s,
            },
            ...ownPast.slice(0, OWN_PAST_MOST - 1),
          ],
        },
  );
}

/** All past alarms, the gateway's and the page's own, newest first. */
export function pastAlarms({ past, ownPast }: Pick<AlarmLogState, "past" | "ownPast">): readonly PastAlarm[] {
  return [...(past ?? []), ...ownPast].sort((first, second) => second.until_s - first.until_s);
}

/**
 * What a user can do about alarms. None throws; outcomes go to the command store under the asker's name and to the
 * messages.
 */
export interface AlarmLog {
  readonly store: AlarmLogStore;
  /** An active alarm, or an ended one that is not acknowledged yet. */
  readonly acknowledge: (id: string, asker: Asker) => Promise<void>;
  /** Acknowledge every alarm that is not yet, ended ones included; does nothing if there is none. */
  readonly acknowledgeAll: () => Promise<void>;
  /** No sound and no speech for two minutes, or until `unmute`. */
  readonly mute: () => void;
  readonly unmute: () => void;
  /** Ask the gateway for the list of past alarms. */
  readonly readPast: () => Promise<void>;
  readonly readThresholds: () => Promise<void>;
  readonly setThreshold: (name: string, value: number, asker: Asker) => Promise<void>;
  /** Unix seconds, this browser's clock. */
  readonly wall_s: () => number;
  /** Sound and speak as an alarm of this level would, whatever is switched on. */
  readonly test: (channel: "sound" | "speech", level: AlarmLevel) => void;
}

export const ALARM_LOG = partName<AlarmLog>("alarm log");
