import { expect, test } from "vitest";
import { createMessages, say } from "./messages";

test("the last message is the one shown, and the same words said again are a new message", () => {
  const store = createMessages();
  const message = { level: "info", key: "said.confirmed", params: { what: "ahrs_on" } } as const;
  say(store, message, 1000);
  say(store, message, 2000);
  expect(store.getState().last).toEqual({ ...message, number: 2, said_ms: 2000 });
});
