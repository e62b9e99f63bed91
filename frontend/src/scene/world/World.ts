import type { NumberedAnswer, NumberedQuestion, WorldAnswers, WorldQuestion } from "./messages";

interface PendingCell {
  readonly resolve: (answer: never) => void;
  readonly reject: (fault: Error) => void;
}

/** The map that ships with the page. Its worker is started with the first question, and lives as long as the page. */
export class World {
  readonly #start: () => Worker;
  readonly #waiting = new Map<number, PendingCell>();
  #worker: Worker | null = null;
  #asked = 0;

  constructor(start: () => Worker) {
    this.#start = start;
  }

  /** Rejects if the file cannot be read or drawn. */
  ask<Kind extends WorldQuestion["kind"]>(
    question: Extract<WorldQuestion, { kind: Kind }>,
  ): Promise<WorldAnswers[Kind]> {
    this.#asked += 1;
    const number = this.#asked;
    const asked = new Promise<WorldAnswers[Kind]>((resolve, reject) => {
      this.#waiting.set(number, { resolve, reject });
    });
    try {
      this.#worker ??= this.#started();
    } catch (error) {
      this.#fail(new Error(String(error)));
      return asked;
    }
    const numbered: NumberedQuestion = { ...question, number };
    this.#worker.postMessage(numbered);
    return asked;
  }

  #started(): Worker {
    const worker = this.#start();
    worker.onmessage = ({ data }: MessageEvent<NumberedAnswer>) => {
      const waiting = this.#waiting.get(data.number);
      this.#waiting.delete(data.number);
      if ("fault" in data) {
        waiting?.reject(new Error(data.fault));
      } else {
        waiting?.resolve(data.answer as never);
      }
    };
    worker.onerror = (event) => {
      event.preventDefault();
      this.#worker = null;
      this.#fail(new Error(event.message));
    };
    return worker;
  }

  #fail(fault: Error): void {
    const waiting = [...this.#waiting.values()];
    this.#waiting.clear();
    for (const { reject } of waiting) {
      reject(fault);
    }
  }
}

let keptRoads: World | null = null;

/** Another worker for the tiles of strangers: what delays it does not delay the chart. */
export function keptVectors(): World {
  keptRoads ??= new World(started);
  return keptRoads;
}

function started(): Worker {
  return new Worker(new URL("./worldWorker.ts", import.meta.url), { type: "module", name: "map" });
}

let kept: World | null = null;

/** The page's one map. */
export function keptWorld(): World {
  kept ??= new World(started);
  return kept;
}
