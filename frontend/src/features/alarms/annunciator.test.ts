import { beforeEach, describe, expect, test } from "vitest";
import { alarmSettings } from "./alarmSettings";
import { type Announcement, Annunciator, type Look, REPEAT_MS } from "./annunciator";
import type { ActiveAlarm, AlarmLevel } from "./raisedAlarms";

const everything = alarmSettings({
  language: "es",
  theme: "dark",
  choices: { "alarms.speech.critical": "on", "alarms.speech.warning": "on" },
});

function alarm(id: string, level: AlarmLevel, parts: Partial<ActiveAlarm> = {}): ActiveAlarm {
  return {
    id,
    level,
    since_s: 1,
    acknowledged: false,
    count: 1,
    message: { level: "warning", key: id, params: {} },
    ...parts,
  };
}

const LOST = alarm("heartbeat_lost", "critical");
const LOW = alarm("battery_low", "warning");

let annunciator: Annunciator;
let now_ms: number;

function look(alarms: readonly ActiveAlarm[], parts: Partial<Look> = {}): Announcement {
  return annunciator.look({
    alarms,
    isRecovered: () => false,
    settings: everything,
    isMuted: false,
    canSound: true,
    canSpeak: true,
    now_ms,
    ...parts,
  });
}

beforeEach(() => {
  annunciator = new Annunciator();
  now_ms = 1000;
});

describe("sound", () => {
  test("a warning sounds once, and again only as another occurrence", () => {
    expect(look([LOW])).toMatchObject({ sound: "warning", again_ms: null });
    expect(look([LOW]).sound).toBeNull();
    look([]);
    expect(look([{ ...LOW, since_s: 9 }]).sound).toBe("warning");
  });

  test("a critical alarm sounds again and again until it is acknowledged", () => {
    expect(look([LOST])).toMatchObject({ sound: "critical", again_ms: now_ms + REPEAT_MS });
    now_ms += REPEAT_MS - 1;
    expect(look([LOST]).sound).toBeNull();
    now_ms += 1;
    expect(look([LOST]).sound).toBe("critical");
    now_ms += REPEAT_MS;
    expect(look([{ ...LOST, acknowledged: true }])).toMatchObject({ sound: null, again_ms: null });
  });

  test("a warning that becomes critical sounds as such", () => {
    look([LOW]);
    expect(look([{ ...LOW, level: "critical" }]).sound).toBe("critical");
  });

  test("a warning that was out of sight while the gateway was not heard is no news when it is back", () => {
    const own = alarm("gateway_lost", "critical", { since_s: 7 });
    look([LOW]);
    expect(look([own]).sound).toBe("critical");
    expect(look([LOW]).sound).toBeNull();
  });

  test("the more urgent of two is what sounds, and the other does not follow it", () => {
    expect(look([LOST, LOW]).sound).toBe("critical");
    expect(look([LOST, LOW]).sound).toBeNull();
  });

  test("what is acknowledged from the first, on another page, never sounds", () => {
    expect(look([{ ...LOST, acknowledged: true }])).toMatchObject({ sound: null, speech: null });
  });

  test("a level that is switched off is silent and is not made up for later", () => {
    const quiet = { ...everything, sound: { critical: false, warning: true } };
    expect(look([LOST], { settings: quiet })).toMatchObject({ sound: null, again_ms: null });
    expect(look([LOST, LOW], { settings: quiet }).sound).toBe("warning");
  });

  test("mute silences what is there and what comes; after it a critical alarm sounds, a warning is not repeated", () => {
    expect(look([LOST, LOW], { isMuted: true })).toMatchObject({ sound: null, speech: null, again_ms: null });
    expect(look([LOW]).sound).toBeNull();
    expect(look([LOST, LOW]).sound).toBe("critical");
  });

  test("what the browser did not let sound yet sounds as soon as it does, if it still holds", () => {
    expect(look([LOW], { canSound: false }).sound).toBeNull();
    expect(look([LOW]).sound).toBe("warning");
    look([LOST], { canSound: false });
    look([], { canSound: false });
    expect(look([]).sound).toBeNull();
  });
});

describe("speech", () => {
  test("says an alarm once, the most urgent of those that came, and how many others there are", () => {
    expect(look([LOST, LOW]).speech).toEqual({
      kind: "raised",
      id: "heartbeat_lost",
      level: "critical",
      others: 1,
    });
    expect(look([LOST, LOW]).speech).toBeNull();
  });

  test("says recovered only when it is seen to be well", () => {
    look([LOST, LOW]);
    expect(look([LOW], { isRecovered: (id) => id === "heartbeat_lost" }).speech).toEqual({
      kind: "recovered",
      id: "heartbeat_lost",
      level: "critical",
      others: 1,
    });
  });

  test("falls silent when an alarm is over and nobody knows that it is well", () => {
    look([LOST]);
    expect(look([]).speech).toBe("hush");
  });

  test("falls silent when somebody acknowledges", () => {
    look([LOST]);
    expect(look([{ ...LOST, acknowledged: true }]).speech).toBe("hush");
  });

  test("a new alarm is said in place of another's recovery: the newest state, and no queue", () => {
    look([LOW]);
    expect(look([LOST], { isRecovered: () => true }).speech).toMatchObject({ kind: "raised", id: LOST.id });
  });

  test("an alarm that comes back at once under the same name is never called recovered", () => {
    look([LOST]);
    expect(look([{ ...LOST, since_s: 5 }], { isRecovered: () => true }).speech).toMatchObject({
      kind: "raised",
    });
  });

  test("what could not be said yet is said once it can, as things are then", () => {
    look([LOST], { canSpeak: false });
    look([LOST, LOW], { canSpeak: false });
    expect(look([LOW]).speech).toMatchObject({ id: "battery_low", others: 0 });
    expect(look([LOW]).speech).toBeNull();
  });

  test("of a level that is switched off nothing is said, not even that it recovered", () => {
    const quiet = { ...everything, speech: { critical: false, warning: true } };
    expect(look([LOST], { settings: quiet }).speech).toBeNull();
    expect(look([], { settings: quiet, isRecovered: () => true }).speech).toBe("hush");
  });
});

test("sound is on and speech is off until somebody chooses, and nonsense on the storage is no volume", () => {
  const fresh = alarmSettings({ language: "es", theme: "dark", choices: { "alarms.volume": "loud" } });
  expect(fresh).toEqual({
    sound: { warning: true, critical: true },
    speech: { warning: false, critical: false },
    volume: 0.5,
  });
});
