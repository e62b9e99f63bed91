import { expect, test } from "vitest";
import { resultMessage } from "./actions";

test("a proof takes some time, also where it rounds to nothing", () => {
  const said = (ms: number) =>
    resultMessage("Next", { state: "confirmed", by: "acknowledgement", ms, reason: null }).params["ms"];
  expect([said(0.4), said(0), said(18.4)]).toEqual(["<1", "<1", 18]);
});
