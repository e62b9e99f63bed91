import { answerOf } from "./answer";
import { CellStore } from "./cellStore";
import type { NumberedAnswer, NumberedQuestion } from "./messages";

// Beside the page: reads the map's cells and draws its tiles, so that the instruments never wait for them.
const store = new CellStore((address, headers) => fetch(address, { headers: { ...headers } }));

/** The part of a worker's global scope that is used here. */
const page = globalThis as unknown as {
  onmessage: ((event: MessageEvent<NumberedQuestion>) => void) | null;
  postMessage: (answer: NumberedAnswer, given: Transferable[]) => void;
};

page.onmessage = ({ data }) => {
  answerOf(store, data).then(
    (answer) => page.postMessage({ number: data.number, answer }, bitmapsOf(answer)),
    (error: unknown) => page.postMessage({ number: data.number, fault: String(error) }, []),
  );
};

function bitmapsOf(answer: unknown): ImageBitmap[] {
  if (answer instanceof ImageBitmap) {
    return [answer];
  }
  const picture =
    answer !== null && typeof answer === "object" && "picture" in answer ? answer.picture : null;
  return picture instanceof ImageBitmap ? [picture] : [];
}
