import type { Timers } from "../../lib/timers";
import type { Language } from "../../store/settings";
import type { Sounder, Speaker } from "./alarmLog";
import { SIGNALS } from "./tones";

type BrowserWindow = Window & typeof globalThis;

/** Events that may be the user gesture which a browser requires before sound. */
const PRESSES = ["pointerdown", "pointerup", "keydown"] as const;
/** A voice that has not begun after this time is not heard. */
export const BEGIN_MS = 1000;
/** What is cancelled ends within this time, or its browser does not tell when. */
export const CANCEL_MS = 250;
/** Tones fade in and out over this time: abrupt ends click. */
const RAMP_S = 0.012;

/** Calls `pressed` at each user gesture that the browser accepts. */
function onPress(window: BrowserWindow, pressed: () => void): void {
  for (const press of PRESSES) {
    window.addEventListener(
      press,
      () => {
        if (hasBeenPressed(window)) {
          pressed();
        }
      },
      { capture: true, passive: true },
    );
  }
}

/** If the browser does not report gestures, believe the event. */
function hasBeenPressed({ navigator }: BrowserWindow): boolean {
  return (navigator.userActivation as UserActivation | undefined)?.hasBeenActive ?? true;
}

/** Tones by Web Audio. The context is made at the first gesture: earlier, the browser refuses it and logs a warning. */
export function browserSounder(window: BrowserWindow): Sounder {
  const changed = new Set<() => void>();
  const tell = (): void => {
    for (const listener of changed) {
      listener();
    }
  };
  let context: AudioContext | null = null;
  let output: GainNode | null = null;

  function wake(): void {
    if (context === null) {
      context = new window.AudioContext();
      context.addEventListener("statechange", tell);
    }
    if (context.state === "suspended") {
      void context.resume();
    }
  }

  function hush(): void {
    output?.disconnect();
    output = null;
  }

  const isKnown = "AudioContext" in window;
  if (isKnown) {
    onPress(window, wake);
  }
  return {
    state: () => (isKnown ? (context?.state === "running" ? "ready" : "waits") : "none"),
    onState: (listener) => changed.add(listener),
    hush,
    play: (level, volume) => {
      if (context?.state !== "running") {
        return;
      }
      hush();
      output = context.createGain();
      output.gain.value = volume;
      output.connect(context.destination);
      const start_s = context.currentTime + RAMP_S;
      for (const { at_s, duration_s, frequency_hz, wave, level: share } of SIGNALS[level]) {
        const tone = context.createOscillator();
        const envelope = context.createGain();
        tone.type = wave;
        tone.frequency.value = frequency_hz;
        const [from_s, to_s] = [start_s + at_s, start_s + at_s + duration_s];
        envelope.gain.setValueAtTime(0, from_s);
        envelope.gain.linearRampToValueAtTime(share, from_s + RAMP_S);
        envelope.gain.setValueAtTime(share, to_s - RAMP_S);
        envelope.gain.linearRampToValueAtTime(0, to_s);
        tone.connect(envelope).connect(output);
        tone.start(from_s);
        tone.stop(to_s);
      }
    },
  };
}

/**
 * The local voices. A remote voice is not used: it would send the words to somebody's server.
 *
 * Chromium on Linux never speaks a sentence that is given before the cancelled one has ended. So nothing is cancelled
 * while nothing is spoken, and the next sentence waits for the end of the one before.
 */
export function browserSpeaker(window: BrowserWindow, timers: Timers): Speaker {
  const synthesis = (window.speechSynthesis as SpeechSynthesis | undefined) ?? null;
  const changed = new Set<() => void>();
  const tell = (): void => {
    for (const listener of changed) {
      listener();
    }
  };
  let isAllowed = false;
  // Kept, because a browser may drop a sentence that nobody holds, with its events.
  let spoken: SpeechSynthesisUtterance | null = null;
  let next: (() => void) | null = null;
  let endWait = nothing;
  if (synthesis !== null) {
    synthesis.addEventListener("voiceschanged", tell);
    onPress(window, () => {
      if (!isAllowed) {
        isAllowed = true;
        tell();
      }
    });
  }
  const voices = (): readonly SpeechSynthesisVoice[] =>
    (synthesis?.getVoices() ?? []).filter(({ localService }) => localService);
  const voiceOf = (language: Language): SpeechSynthesisVoice | undefined =>
    voices().find(({ lang }) => lang.toLowerCase().startsWith(language));

  function stop(): void {
    endWait();
    endWait = nothing;
    next = null;
    if (spoken !== null) {
      synthesis?.cancel();
    }
  }

  function begin(sentence: SpeechSynthesisUtterance, told: (isHeard: boolean) => void): void {
    spoken = sentence;
    endWait = timers.after(BEGIN_MS, () => {
      stop();
      told(false);
    });
    sentence.addEventListener("start", () => {
      if (spoken === sentence) {
        endWait();
        told(true);
      }
    });
    for (const end of ["end", "error"]) {
      sentence.addEventListener(end, () => {
        if (spoken === sentence) {
          ended();
        }
      });
    }
    synthesis?.speak(sentence);
  }

  function ended(): void {
    const following = next;
    spoken = null;
    next = null;
    if (following !== null) {
      endWait();
      following();
    }
  }

  return {
    state: (language) => {
      if (voices().length === 0) {
        return "none";
      }
      if (voiceOf(language) === undefined) {
        return "foreign";
      }
      return isAllowed ? "ready" : "waits";
    },
    onState: (listener) => changed.add(listener),
    hush: stop,
    say: (text, language, volume, told) => {
      const voice = voiceOf(language);
      if (synthesis === null || voice === undefined) {
        return;
      }
      const sentence = new window.SpeechSynthesisUtterance(text);
      sentence.voice = voice;
      sentence.lang = voice.lang;
      sentence.volume = volume;
      stop();
      if (spoken === null) {
        begin(sentence, told);
      } else {
        next = () => begin(sentence, told);
        endWait = timers.after(CANCEL_MS, ended);
      }
    },
  };
}

function nothing(): void {}
