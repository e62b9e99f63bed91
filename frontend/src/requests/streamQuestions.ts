import type { Timers } from "../lib/timers";

/** Asks the replay about the moment of a flight that it shows; null where no answer comes. */
export type AskReplay = (about: "inspector" | "known") => Promise<unknown>;

export interface StreamQuestions {
  readonly ask: AskReplay;
  /** An answer came. They come in the order of the questions. */
  readonly answered: (about: string, data: unknown) => void;
  /** The line broke: what was asked is not answered any more. */
  readonly lost: () => void;
}

/** A replay answers within milliseconds; a longer silence is a broken line. */
const PATIENCE_MS = 2000;

interface Open {
  readonly about: string;
  readonly answer: (data: unknown) => void;
}

/** Questions and answers over a stream. `send` returns false where the line is not well. */
export function createStreamQuestions(send: (text: string) => boolean, timers: Timers): StreamQuestions {
  let open: Open[] = [];

  function close(one: Open, data: unknown): void {
    open = open.filter((other) => other !== one);
    one.answer(data);
  }

  return {
    ask: (about) =>
      new Promise((resolve) => {
        if (!send(JSON.stringify({ type: "ask", about }))) {
          resolve(null);
          return;
        }
        const one: Open = {
          about,
          answer: (data) => {
            cancel();
            resolve(data);
          },
        };
        const cancel = timers.after(PATIENCE_MS, () => close(one, null));
        open.push(one);
      }),
    answered: (about, data) => {
      const one = open.find((other) => other.about === about);
      if (one !== undefined) {
        close(one, data);
      }
    },
    lost: () => {
      for (const one of open) {
        close(one, null);
      }
    },
  };
}
