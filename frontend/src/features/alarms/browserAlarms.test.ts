import { beforeEach, describe, expect, test, vi } from "vitest";
import { browserSounder, browserSpeaker } from "./browserAlarms";
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
    speak: ({ text, lang }: { text: string; lang: string }) => this.spoken.push(`${lang} ${text}`),
  });
  readonly SpeechSynthesisUtterance = class {
    lang = "";
    voice: unknown = null;
    volume = 1;
    readonly text: string;
    constructor(text: string) {
      this.text = text;
    }
  };

  press(): void {
    this.navigator.userActivation.hasBeenActive = true;
    this.dispatchEvent(new Event("pointerdown"));
  }

  get asBrowser(): Window & typeof globalThis {
    return this as unknown as Window & typeof globalThis;
  }
}

let window: FakeWindow;

beforeEach(() => {
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
    expect(browserSpeaker(bare).state("es")).toBe("none");
  });
});

describe("voices", () => {
  test("speak the page's language after a press, and never two sentences in a row", () => {
    const speaker = browserSpeaker(window.asBrowser);
    expect(speaker.state("es")).toBe("waits");
    window.press();
    expect(speaker.state("es")).toBe("ready");
    speaker.say("uno", "es", 1);
    speaker.say("two", "en", 1);
    expect(window.spoken).toEqual(["cancel", "es-ES uno", "cancel", "en-GB two"]);
  });

  test("of another language are not taken, nor those that live on a server", () => {
    const speaker = browserSpeaker(window.asBrowser);
    window.press();
    window.voices = [voice("en-GB"), voice("es-ES", false)];
    expect(speaker.state("es")).toBe("foreign");
    speaker.say("uno", "es", 1);
    expect(window.spoken).toEqual([]);
    window.voices = [voice("es-ES", false)];
    expect(speaker.state("es")).toBe("none");
  });

  test("that are found later are told", () => {
    window.voices = [];
    const speaker = browserSpeaker(window.asBrowser);
    const changed = vi.fn();
    speaker.onState(changed);
    window.voices = [voice("es-ES")];
    window.speechSynthesis.dispatchEvent(new Event("voiceschanged"));
    expect(changed).toHaveBeenCalledOnce();
    expect(speaker.state("es")).toBe("waits");
  });
});
