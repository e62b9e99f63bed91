import { Repeating } from "../../lib/repeating";
import type { Timers } from "../../lib/timers";
import { isAlarmBook, isThresholdList } from "../../protocol/guards.gen";
import { createAsking, info, type RequesterParts } from "../../requests/asking";
import type { Connection, ConnectionStore } from "../../store/connection";
import { failureMessage } from "../../store/messages";
import type { SettingsStore } from "../../store/settings";
import type { TelemetryStore } from "../../store/telemetry";
import {
  type AlarmLog,
  type AlarmLogStore,
  acknowledgeOwn,
  createAlarmLogStore,
  endOwn,
  endRestart,
  MUTE_MS,
  raiseOwn,
  type Sounder,
  type Speaker,
} from "./alarmLog";
import { spokenPhrase, testPhrase } from "./alarmPhrases";
import { alarmSettings } from "./alarmSettings";
import { Annunciator, type Speech } from "./annunciator";
import { endedAlarms } from "./endedAlarms";
import { type AlarmLevel, activeAlarms, BOARD_RESTARTED, GATEWAY_LOST, isRecovered } from "./raisedAlarms";

export interface AlarmParts extends RequesterParts {
  readonly connection: ConnectionStore;
  readonly telemetry: TelemetryStore;
  readonly settings: SettingsStore;
  readonly timers: Timers;
  readonly sounder: Sounder;
  readonly speaker: Speaker;
}

/** The alarms' side of the page: what is asked of the gateway about them, and what is heard of them. */
export function createAlarmLog(parts: AlarmParts): AlarmLog {
  const { rest, connection, wall_ms } = parts;
  const { run, simply } = createAsking(parts);
  const store = createAlarmLogStore();
  const speak = createVoice(parts, store);
  const ring = createBell(parts, store, speak);
  // Subscribed before anything else reads the state, so that the page's own alarm is there from the start.
  connection.subscribe((now) => followLine(now, store, wall_ms() / 1000));
  connection.subscribe(ring);
  parts.settings.subscribe(ring);
  store.subscribe((now, before) => {
    if (
      now.own !== before.own ||
      now.restart !== before.restart ||
      now.mutedUntil_ms !== before.mutedUntil_ms
    ) {
      ring();
    }
  });
  watchBrowser(parts, store, ring);

  async function acknowledge(id: string, control: string): Promise<void> {
    if (id === GATEWAY_LOST) {
      acknowledgeOwn(store);
      return;
    }
    if (id === BOARD_RESTARTED) {
      endRestart(store, wall_ms() / 1000);
      return;
    }
    await simply(
      { control },
      ["POST", `/api/v1/alarms/${encodeURIComponent(id)}/acknowledge`],
      info("alarmSaid.acknowledged", { what: `@alarmName.${id}` }),
    );
  }

  return {
    store,
    acknowledge: (id, asker) => acknowledge(id, asker.control),
    acknowledgeAll: async () => {
      const { own, ownEnded, restart } = store.getState();
      const now = connection.getState();
      const open = activeAlarms(now, own, restart).filter(({ acknowledged }) => !acknowledged);
      const ids = [...open, ...endedAlarms(now, ownEnded)].map(({ id }) => id);
      await Promise.all(ids.map((id) => acknowledge(id, `acknowledge.${id}`)));
    },
    mute: () => {
      parts.sounder.hush();
      parts.speaker.hush();
      store.setState({ mutedUntil_ms: parts.now_ms() + MUTE_MS });
    },
    wall_s: () => wall_ms() / 1000,
    unmute: () => store.setState({ mutedUntil_ms: null }),
    readPast: async () => {
      const answer = await rest.ask("GET", "/api/v1/alarms", isAlarmBook);
      store.setState(
        answer.ok ? { past: answer.value.past, failure: null } : { failure: failureMessage(answer.problem) },
      );
    },
    readThresholds: async () => {
      const answer = await rest.ask("GET", "/api/v1/alarms/thresholds", isThresholdList);
      store.setState(
        answer.ok ? { ...answer.value, failure: null } : { failure: failureMessage(answer.problem) },
      );
    },
    setThreshold: (name, value, asker) =>
      run(
        asker,
        rest.ask("PUT", "/api/v1/alarms/thresholds", isThresholdList, { [name]: value }),
        (limits) => {
          store.setState(limits);
          return {
            state: "confirmed",
            message: info("alarmSaid.threshold", { what: `@alarmThreshold.${name}`, value }),
          };
        },
      ),
    test: (channel, level) => {
      if (channel === "sound") {
        parts.sounder.play(level, alarmSettings(parts.settings.getState()).volume);
      } else {
        speak({ kind: "test", level });
      }
    },
  };
}

/** Raise the page's own alarm when its connection falls silent or breaks, and end it when it is open again. */
function followLine({ phase, status }: Connection, store: AlarmLogStore, now_s: number): void {
  if (phase === "open") {
    endOwn(store, now_s, { id: GATEWAY_LOST, text: "The gateway was not heard." });
  } else if (phase !== "connecting" || status !== null) {
    raiseOwn(store, now_s);
  }
}

/** Sound and speech become available with the first user gesture, and as voices are found. */
function watchBrowser({ sounder, speaker }: AlarmParts, store: AlarmLogStore, ring: () => void): void {
  const look = (): void => {
    store.setState({
      sounder: sounder.state(),
      speaker: { es: speaker.state("es"), en: speaker.state("en") },
    });
    ring();
  };
  look();
  sounder.onState(look);
  speaker.onState(look);
}

/** What the voice says; "hush" ends what it is saying. */
type Speak = (speech: Speech | "hush" | { readonly kind: "test"; readonly level: AlarmLevel }) => void;

/** If the voice does not begin, the tone of the alarm sounds instead, and the user is told so once. */
function createVoice({ settings, sounder, speaker, messages }: AlarmParts, store: AlarmLogStore): Speak {
  let isHeard = true;
  return (speech) => {
    if (speech === "hush") {
      speaker.hush();
      return;
    }
    const { language } = settings.getState();
    const { volume } = alarmSettings(settings.getState());
    const text = speech.kind === "test" ? testPhrase(speech.level, language) : spokenPhrase(speech, language);
    speaker.say(text, language, volume, (isHeardNow) => {
      const wasHeard = isHeard;
      isHeard = isHeardNow;
      if (isHeard || store.getState().mutedUntil_ms !== null) {
        return;
      }
      if (wasHeard) {
        messages.announce({ level: "warning", key: "alarmSaid.unheard", params: {} });
      }
      // An alarm's tone would say the opposite of "recovered".
      if (speech.kind !== "recovered") {
        sounder.play(speech.level, volume);
      }
    });
  };
}

/** Whatever a sound throws, the alarms are examined again so soon. */
const AFTER_FAILURE_MS = 1000;

/**
 * Lets the annunciator examine the alarms and does what it decides. It runs after the present message has been
 * handled completely: half-way, a link may already be open while the status is still the old one.
 */
function createBell(parts: AlarmParts, store: AlarmLogStore, speak: Speak): () => void {
  const { connection, telemetry, settings, timers, sounder, speaker } = parts;
  const annunciator = new Annunciator();
  let isCalled = false;
  const looks = new Repeating(timers, look, AFTER_FAILURE_MS);

  function look(): number | null {
    isCalled = false;
    const now_ms = timers.now_ms();
    const { own, restart, mutedUntil_ms } = store.getState();
    const isMuted = mutedUntil_ms !== null && now_ms < mutedUntil_ms;
    if (mutedUntil_ms !== null && !isMuted) {
      store.setState({ mutedUntil_ms: null });
    }
    const facts = connection.getState();
    const chosen = settings.getState();
    const heard = alarmSettings(chosen);
    const { sound, speech, again_ms } = annunciator.look({
      alarms: activeAlarms(facts, own, restart),
      isRecovered: (id) => isRecovered(id, facts, telemetry, now_ms),
      settings: heard,
      isMuted,
      canSound: sounder.state() === "ready",
      canSpeak: speaker.state(chosen.language) === "ready",
      now_ms,
    });
    try {
      if (sound !== null) {
        sounder.play(sound, heard.volume);
      }
    } finally {
      if (speech !== null) {
        speak(speech);
      }
    }
    const next_ms = isMuted ? mutedUntil_ms : again_ms;
    return next_ms === null ? null : next_ms - now_ms;
  }

  function ring(): void {
    if (!isCalled) {
      isCalled = true;
      looks.cancel();
      looks.arm(0);
    }
  }
  return ring;
}
