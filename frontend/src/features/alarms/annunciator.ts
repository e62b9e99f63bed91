import type { AlarmSettings } from "./alarmSettings";
import type { ActiveAlarm, AlarmLevel } from "./raisedAlarms";

/** A critical alarm that nobody has acknowledged sounds again after this time. */
export const REPEAT_MS = 4000;

/** A bound that no flight reaches, so that a page that stays open for weeks does not grow. */
const MET_MOST = 1000;

/** The phrase to speak: the most urgent alarm, and how many others there are. */
export interface Speech {
  readonly kind: "raised" | "recovered";
  readonly id: string;
  readonly level: AlarmLevel;
  readonly others: number;
}

/** What to do now. `speech`: null leaves what is being spoken, "hush" stops it because it is no longer true. */
export interface Announcement {
  readonly sound: AlarmLevel | null;
  readonly speech: Speech | "hush" | null;
  /** When to examine again if nothing changes; null for never. */
  readonly again_ms: number | null;
}

export interface Look {
  readonly alarms: readonly ActiveAlarm[];
  /** Whether an ended alarm is proven to have recovered. */
  readonly isRecovered: (id: string) => boolean;
  readonly settings: AlarmSettings;
  /** The user muted the alarms. */
  readonly isMuted: boolean;
  /** Whether the browser allows sound yet; until then unheard alarms are kept. */
  readonly canSound: boolean;
  readonly canSpeak: boolean;
  readonly now_ms: number;
}

/**
 * Decides which alarms sound and are spoken. Each occurrence sounds once; an unacknowledged critical one repeats.
 * Nothing is queued: every phrase is true when it is spoken and replaces the one before.
 */
export class Annunciator {
  /** Active alarms at the last examination, by occurrence. */
  #known = new Map<string, ActiveAlarm>();
  /**
   * Occurrences already announced. While the gateway is not heard its alarms are unknown; afterwards they must not
   * sound as new.
   */
  readonly #met = new Set<string>();
  /** Occurrences that have not been heard yet. */
  #unsounded = new Set<string>();
  #unsaid: string | null = null;
  #repeat_ms = Number.NEGATIVE_INFINITY;

  look({ alarms, isRecovered, settings, isMuted, canSound, canSpeak, now_ms }: Look): Announcement {
    const current = new Map(alarms.map((alarm) => [occurrence(alarm), alarm]));
    const came = [...current.keys()].filter((key) => !this.#met.has(key));
    this.#meet(came);
    const ids = new Set(alarms.map(({ id }) => id));
    const gone = [...this.#known.values()].filter(({ id }) => !ids.has(id));
    const wasAcknowledged = [...current].some(
      ([key, { acknowledged }]) => acknowledged && this.#known.get(key)?.acknowledged === false,
    );
    this.#known = current;
    const open = alarms.filter(({ acknowledged }) => !acknowledged);
    const sound = this.#sound(open, came, { settings, isMuted, canSound, now_ms });
    const speech = this.#speech(open, came, { settings, isMuted, canSpeak });
    const repeats = !isMuted && canSound && settings.sound.critical && open.some(isCritical);
    return {
      sound,
      speech: speech ?? recovery(gone, alarms, { isRecovered, settings, isMuted, canSpeak, wasAcknowledged }),
      again_ms: repeats ? Math.max(this.#repeat_ms, now_ms + 1) : null,
    };
  }

  #meet(came: readonly string[]): void {
    for (const key of came) {
      this.#met.add(key);
    }
    for (const oldest of this.#met) {
      if (this.#met.size <= MET_MOST) {
        break;
      }
      this.#met.delete(oldest);
    }
  }

  /** The level to sound now: the most urgent of what has not been heard, or a critical alarm's repetition. */
  #sound(
    open: readonly ActiveAlarm[],
    came: readonly string[],
    { settings, isMuted, canSound, now_ms }: Pick<Look, "settings" | "isMuted" | "canSound" | "now_ms">,
  ): AlarmLevel | null {
    const keys = new Set(open.map(occurrence));
    this.#unsounded = new Set([...this.#unsounded, ...came].filter((key) => keys.has(key)));
    if (isMuted || !canSound) {
      if (isMuted) {
        this.#unsounded.clear();
      }
      return null;
    }
    const due = open.filter(
      (alarm) =>
        settings.sound[alarm.level] &&
        (this.#unsounded.has(occurrence(alarm)) || (isCritical(alarm) && now_ms >= this.#repeat_ms)),
    );
    this.#unsounded.clear();
    if (due.length === 0) {
      return null;
    }
    if (!due.some(isCritical)) {
      return "warning";
    }
    this.#repeat_ms = now_ms + REPEAT_MS;
    return "critical";
  }

  /** The most urgent alarm that was not spoken yet. */
  #speech(
    open: readonly ActiveAlarm[],
    came: readonly string[],
    { settings, isMuted, canSpeak }: Pick<Look, "settings" | "isMuted" | "canSpeak">,
  ): Speech | null {
    const wanted = open.filter(({ level }) => settings.speech[level]);
    const newest = wanted.find((alarm) => came.includes(occurrence(alarm)));
    const kept = wanted.find((alarm) => occurrence(alarm) === this.#unsaid);
    const next = newest ?? kept;
    if (isMuted || next === undefined) {
      this.#unsaid = null;
      return null;
    }
    if (!canSpeak) {
      this.#unsaid = occurrence(next);
      return null;
    }
    this.#unsaid = null;
    return { kind: "raised", id: next.id, level: next.level, others: open.length - 1 };
  }
}

/** The phrase for ended alarms: recovered, where that is proven, else nothing. */
function recovery(
  gone: readonly ActiveAlarm[],
  alarms: readonly ActiveAlarm[],
  {
    isRecovered,
    settings,
    isMuted,
    canSpeak,
    wasAcknowledged,
  }: Pick<Look, "isRecovered" | "settings" | "isMuted" | "canSpeak"> & { readonly wasAcknowledged: boolean },
): Speech | "hush" | null {
  const well = gone.find(({ id, level }) => settings.speech[level] && isRecovered(id));
  if (well !== undefined && !isMuted && canSpeak) {
    return { kind: "recovered", id: well.id, level: well.level, others: alarms.length };
  }
  return gone.length > 0 || wasAcknowledged ? "hush" : null;
}

function isCritical({ level }: ActiveAlarm): boolean {
  return level === "critical";
}

/** An alarm that is raised again, or becomes worse, is a new occurrence. */
function occurrence({ id, since_s, level }: ActiveAlarm): string {
  return `${id}@${since_s}@${level}`;
}
