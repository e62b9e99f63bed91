import { FieldSamples } from "../../lib/fieldSamples";
import { isCommandOutcome } from "../../protocol/guards.gen";
import { resultMessage } from "../../requests/actions";
import type { Asker } from "../../requests/asking";
import { createAsking, type RequesterParts } from "../../requests/asking";
import { type Ahrs3d, createAlignment } from "./alignment";

const PATH = "/api/v1/ahrs-test";

export function createAhrs3d(parts: RequesterParts): Ahrs3d {
  const { run } = createAsking(parts);
  const ask = (method: "POST" | "DELETE", name: string) => (asker: Asker) =>
    run(asker, parts.rest.ask(method, PATH, isCommandOutcome), (result) => ({
      state: result.state,
      message: resultMessage(`@command.${name}`, result),
    }));
  return {
    alignment: createAlignment(),
    samples: new FieldSamples(),
    startTest: ask("POST", "ahrs_test_start"),
    stopTest: ask("DELETE", "ahrs_test_stop"),
  };
}
