import { expect, test } from "vitest";
import { createMessages, failureMessage, say } from "./messages";

test("the last message is the one shown, and the same words said again are a new message", () => {
  const store = createMessages();
  const message = { level: "info", key: "said.confirmed", params: { what: "ahrs_on" } } as const;
  say(store, message, 1000);
  say(store, message, 2000);
  expect(store.getState().last).toEqual({ ...message, number: 2, said_ms: 2000 });
});

test("a refusal is an error of its code, with the values that a sentence can say and the gateway's own text", () => {
  const params = { what: "ahrs_on", seconds: 2, isLost: true, link: null, rows: [3] };
  expect(failureMessage({ code: "timed_out", detail: "Nothing came.", params })).toEqual({
    level: "error",
    key: "problem.timed_out",
    params: { what: "ahrs_on", seconds: 2 },
    fallback: "Nothing came.",
  });
});

test("nothing is said before the first message", () => {
  expect(createMessages().getState()).toEqual({ last: null });
});
