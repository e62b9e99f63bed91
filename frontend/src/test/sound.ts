import type { Sounder, SounderState, Speaker, SpeakerState } from "../features/alarms/alarmLog";
import type { AlarmLevel } from "../features/alarms/raisedAlarms";

/** Records tones. */
export class ManualSounder implements Sounder {
  readonly played: Array<AlarmLevel | "hush"> = [];
  #state: SounderState = "ready";
  readonly #listeners: Array<() => void> = [];

  readonly state = (): SounderState => this.#state;
  /** What playing a tone throws. */
  failure: Error | null = null;
  readonly play = (level: AlarmLevel): void => {
    if (this.failure !== null) {
      throw this.failure;
    }
    this.played.push(level);
  };
  readonly hush = (): void => {
    this.played.push("hush");
  };
  readonly onState = (changed: () => void): void => {
    this.#listeners.push(changed);
  };

  become(state: SounderState): void {
    this.#state = state;
    for (const changed of this.#listeners) {
      changed();
    }
  }
}

/** Records sentences. */
export class ManualSpeaker implements Speaker {
  readonly said: string[] = [];
  #state: SpeakerState = "ready";
  readonly #listeners: Array<() => void> = [];

  readonly state = (): SpeakerState => this.#state;
  /** Whether the voice begins. */
  isHeard = true;
  readonly say: Speaker["say"] = (text, language, _volume, told) => {
    this.said.push(`${language}: ${text}`);
    told(this.isHeard);
  };
  readonly hush = (): void => {
    this.said.push("hush");
  };
  readonly onState = (changed: () => void): void => {
    this.#listeners.push(changed);
  };

  become(state: SpeakerState): void {
    this.#state = state;
    for (const changed of this.#listeners) {
      changed();
    }
  }
}
