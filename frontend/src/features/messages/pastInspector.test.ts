import { expect, test } from "vitest";
import { createPastInspector } from "./pastInspector";

const answer = {
  board: { link: "open", frames: 0, damaged: 0, unknown: 0, topics: [], sent: [] },
};

test("what the replay counted is asked by its name, and anything that is no inspection says that it is silent", async () => {
  const asked: string[] = [];
  const inspector = createPastInspector((about) => {
    asked.push(about);
    return Promise.resolve(answer);
  });
  expect(await inspector.read()).toEqual({ level: "error", key: "messages.pastSilent", params: {} });
  expect(asked).toEqual(["inspector"]);
});
