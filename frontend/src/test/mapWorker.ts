import { vi } from "vitest";
import type { NumberedQuestion } from "../scene/world/messages";

/** What the map's worker answers to each kind of question; a string is its fault. */
let answers: Record<string, unknown> = {};

/** The worker's end of the wire: it answers as the real one does, later. */
class AnsweringWorker {
  onmessage: ((event: { data: unknown }) => void) | null = null;

  postMessage({ number, kind }: NumberedQuestion): void {
    const answer = answers[kind];
    const data = typeof answer === "string" ? { number, fault: answer } : { number, answer };
    queueMicrotask(() => this.onmessage?.({ data }));
  }
}

/**
 * The page's one map keeps its first worker, and files share the page's modules: so all tests
 * answer through this one, whichever of them comes first.
 */
export function answerMap(next: Record<string, unknown>): void {
  answers = next;
  vi.stubGlobal("Worker", AnsweringWorker);
}
