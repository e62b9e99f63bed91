import { expect, test } from "vitest";
import type { Globe } from "../globe/Globe";
import { LayerStack, type ShownLayer } from "./LayerStack";

const WORLD = {
  west_deg: -180,
  south_deg: -85,
  east_deg: 180,
  north_deg: 85,
  minimum_zoom: 0,
  maximum_zoom: 5,
};
const layer = (id: string, opacity = 1): ShownLayer => ({ ...WORLD, id, url: `/${id}`, opacity });

/** A ground that records what is done to it. */
function stackOn(setTerrain: (source: { url: string } | null) => Promise<void> = async () => undefined) {
  const done: string[] = [];
  const ground = {
    addImagery: ({ url }: { url: string }) => {
      done.push(`add ${url}`);
      return {
        setVisible: () => undefined,
        setOpacity: (opacity: number) => done.push(`opacity ${url} ${opacity}`),
        remove: () => done.push(`remove ${url}`),
      };
    },
    setTerrain,
  };
  return { done, stack: new LayerStack({ ground } as unknown as Globe) };
}

test("layers are laid from below, and one more on top leaves them alone", () => {
  const { done, stack } = stackOn();
  stack.show([layer("b"), layer("a")]);
  expect(done).toEqual(["add /a", "opacity /a 1", "add /b", "opacity /b 1"]);
  done.length = 0;
  stack.show([layer("c", 0.5), layer("b"), layer("a")]);
  expect(done).toEqual(["add /c", "opacity /c 0.5"]);
});

test("another opacity fetches nothing again", () => {
  const { done, stack } = stackOn();
  stack.show([layer("a")]);
  done.length = 0;
  stack.show([layer("a", 0.3)]);
  expect(done).toEqual(["opacity /a 0.3"]);
});

test("of another order all above the first difference is laid anew; what is gone is taken off", () => {
  const { done, stack } = stackOn();
  stack.show([layer("c"), layer("b"), layer("a")]);
  done.length = 0;
  stack.show([layer("b"), layer("a")]);
  expect(done).toEqual(["remove /c"]);
  stack.show([layer("a")]);
  stack.show([]);
  expect(done).toEqual(["remove /c", "remove /b", "remove /a"]);
});

test("terrain that cannot be read is told, and the ground is flat again", async () => {
  const asked: (string | null)[] = [];
  const { stack } = stackOn(async (source) => {
    asked.push(source?.url ?? null);
    if (source !== null) throw new Error("404");
  });
  await expect(stack.showTerrain("/bad")).rejects.toThrow("404");
  expect(asked).toEqual(["/bad", null]);
  await stack.showTerrain(null);
  expect(asked).toEqual(["/bad", null]);
});
