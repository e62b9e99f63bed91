import { expect, test } from "vitest";
import { Parts, partName } from "./parts";

test("a part is found by its own name, and by no other of the same wording", () => {
  const name = partName<number>("speed");
  const parts = new Parts().with(name, 5);
  expect(parts.get(name)).toBe(5);
  expect(() => parts.get(partName<number>("speed"))).toThrow("without its speed");
});
