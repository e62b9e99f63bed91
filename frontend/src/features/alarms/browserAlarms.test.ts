import { beforeEach, describe, expect, test, vi } from "vitest";
import { ManualTimers } from "../../test/wire";
import { BEGIN_MS, browserSounder, browserSpeaker, CANCEL_MS } from "./browserAlarms";
import { SIGNALS } from "./tones";

/** As much of a browser's sound as is used: nodes that remember what they were connected to and when they sound. */
class FakeContext extends EventTarget {
  static made: FakeContext[] = [];
  state: AudioContextState = "suspended";
  currentTime = 10;
  destination = {};
  readonly tones: Array<{ from_s: number; to_s: number; frequency_hz: number }> = [];
  readonly disconnected: unknown[] = [];

  constructor() {
    super();
    FakeContext.made.push(this);
  }

  resume = async (): Promise<void> => {
    this.state = "running";
    this.dispatchEvent(new Event("statechange"));
  };

  createGain() {
    const gain = { value: 1, setValueAtTime: vi.fn(), linearRampToValueAtTime: vi.fn() };
    const node = { gain, connect: <T>(to: T): T => to, disconnect: () => this.disconnected.push(node) };
    return node;
  }

  createOscillator() {
    const tone = { from_s: 0, to_s: 0, frequency_hz: 0 };
    this.tones.push(tone);
    return {
      type: "",
      frequency: {
        set value(hz: number) {
          tone.frequency_hz = hz;
        },
      },
      connect: <T>(to: T): T => to,
      start: (at_s: number) => {
        tone.from_s = at_s;
      },
      stop: (at_s: number) => {
        tone.to_s = at_s;
      },
    };
  }
}

function voice(lang: string, localService = true): SpeechSynthesisVoice {
  return { lang, localService, name: lang, voiceURI: lang, default: false };
}

/** A window with sound, voices, and presses at the test's command. */
class FakeWindow extends EventTarget {
  readonly AudioContext = FakeContext;
  readonly navigator = { userActivation: { hasBeenActive: false } };
  voices: SpeechSynthesisVoice[] = [voice("en-GB"), voice("es-ES")];
  readonly spoken: string[] = [];
  readonly speechSynthesis = Object.assign(new EventTarget(), {
    getVoices: () => this.voices,
    cancel: () => this.spoken.push("cancel"),
    speak: (sentence: EventTarget & { text: string; lang: string }) => {
      this.spoken.push(`${sentence.lang} ${sentence.text}`);
      this.sentences.push(sentence);
    },
  });
  /** What was given to the browser to speak; the test says when it begins and ends. */
  readonly sentences: EventTarget[] = [];
  readonly SpeechSynthesisUtterance = class extends EventTarget {
    lang = "";
    voice: unknown = null;
    volume = 1;
    readonly text: string;
    constructor(text: string) {
      super();
      this.text = text;
    }
  };

  tell(number: number, event: "start" | "end" | "error"): void {
    this.sentences[number]?.dispatchEvent(new Event(event));
  }

  press(): void {
    this.navigator.userActivation.hasBeenActive = true;
    this.dispatchEvent(new Event("pointerdown"));
  }

  get asBrowser(): Window & typeof globalThis {
    return this as unknown as Window & typeof globalThis;
  }
}

let window: FakeWindow;
let timers: ManualTimers;

beforeEach(() => {
  timers = new ManualTimers();
  FakeContext.made = [];
  window = new FakeWindow();
});

describe("tones", () => {
  test("make no sound context before the first press, for the browser would complain", () => {
    const sounder = browserSounder(window.asBrowser);
    sounder.play("critical", 0.5);
    window.dispatchEvent(new Event("keydown")); // Escape, which a browser does not count
    expect(FakeContext.made).toEqual([]);
    expect(sounder.state()).toBe("waits");
  });

  test("tell when the press has come", async () => {
    const sounder = browserSounder(window.asBrowser);
    const changed = vi.fn();
    sounder.onState(changed);
    window.press();
    await expect.poll(() => changed).toHaveBeenCalled();
    expect(sounder.state()).toBe("ready");
    expect(FakeContext.made).toHaveLength(1);
  });

  test("are different for a warning and an alarm, and the newer one ends the older", async () => {
    const sounder = browserSounder(window.asBrowser);
    window.press();
    await expect.poll(() => sounder.state()).toBe("ready");
    const [context] = FakeContext.made;
    sounder.play("warning", 0.5);
    expect(context?.tones.map(({ frequency_hz }) => frequency_hz)).toEqual([660, 880]);
    sounder.play("critical", 0.5);
    expect(context?.disconnected).toHaveLength(1);
    expect(context?.tones).toHaveLength(SIGNALS.warning.length + SIGNALS.critical.length);
    expect(context?.tones.every(({ from_s, to_s }) => from_s >= 10 && to_s > from_s)).toBe(true);
  });

  test("of a browser without them say so", () => {
    const bare = Object.assign(new EventTarget(), { navigator: {} }) as unknown as Window & typeof globalThis;
    expect(browserSounder(bare).state()).toBe("none");
    expect(browserSpeaker(bare, timers).state("es")).toBe("none");
  });
});

describe("voices", () => {
  /** A speaker after the first press, and what it tells of its sentences. */
  function speaking() {
    const speaker = browserSpeaker(window.asBrowser, timers);
    window.press();
    const told: string[] = [];
    const say = (text: string, language: "es" | "en" = "es") =>
      speaker.say(text, language, 1, (isHeard) => told.push(`${text} ${isHeard ? "heard" : "unheard"}`));
    return { speaker, say, told };
  }

  test("speak the page's language after a press, and cancel nothing while nothing is spoken", () => {
    const speaker = browserSpeaker(window.asBrowser, timers);
    expect(speaker.state("es")).toBe("waits");
    window.press();
    expect(speaker.state("es")).toBe("ready");
    speaker.hush();
    speaker.say("uno", "es", 1, vi.fn());
    expect(window.spoken).toEqual(["es-ES uno"]);
  });

  test("begin the newest sentence only when the cancelled one has ended", () => {
    const { say, told } = speaking();
    say("uno");
    window.tell(0, "start");
    say("two", "en");
    say("tres");
    expect(window.spoken).toEqual(["es-ES uno", "cancel", "cancel"]);
    window.tell(0, "error");
    expect(window.spoken.at(-1)).toBe("es-ES tres");
    window.tell(1, "start");
    window.tell(1, "end");
    say("cuatro");
    expect(window.spoken.slice(3)).toEqual(["es-ES tres", "es-ES cuatro"]);
    expect(told).toEqual(["uno heard", "tres heard"]);
  });

  test("do not wait long for a browser that never tells the end of what it cancelled", () => {
    const { say, told } = speaking();
    say("uno");
    window.tell(0, "start");
    say("dos");
    timers.pass(CANCEL_MS);
    expect(window.spoken.at(-1)).toBe("es-ES dos");
    window.tell(0, "error");
    window.tell(1, "start");
    expect(told).toEqual(["uno heard", "dos heard"]);
  });

  test("that do not begin within a second are told as unheard, and do not speak later", () => {
    const { say, told } = speaking();
    say("uno");
    timers.pass(BEGIN_MS - 1);
    expect(told).toEqual([]);
    timers.pass(1);
    expect(told).toEqual(["uno unheard"]);
    expect(window.spoken).toEqual(["es-ES uno", "cancel"]);
  });

  test("that are hushed say nothing more, neither aloud nor to who asked", () => {
    const { speaker, say, told } = speaking();
    say("uno");
    window.tell(0, "start");
    say("dos");
    speaker.hush();
    window.tell(0, "error");
    timers.pass(BEGIN_MS);
    expect(window.spoken).not.toContain("es-ES dos");
    expect(told).toEqual(["uno heard"]);
  });

  test("of another language are not taken, nor those that live on a server", () => {
    const speaker = browserSpeaker(window.asBrowser, timers);
    window.press();
    window.voices = [voice("en-GB"), voice("es-ES", false)];
    expect(speaker.state("es")).toBe("foreign");
    speaker.say("uno", "es", 1, vi.fn());
    expect(window.spoken).toEqual([]);
    window.voices = [voice("es-ES", false)];
    expect(speaker.state("es")).toBe("none");
  });

  test("that are found later are told", () => {
    window.voices = [];
    const speaker = browserSpeaker(window.asBrowser, timers);
    const changed = vi.fn();
    speaker.onState(changed);
    window.voices = [voice("es-ES")];
    window.speechSynthesis.dispatchEvent(new Event("voiceschanged"));
    expect(changed).toHaveBeenCalledOnce();
    expect(speaker.state("es")).toBe("waits");
  });
});
