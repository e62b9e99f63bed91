import { describe, expect, test } from "vitest";
import { addressFault, movedLayer, rememberedStack, sourceId, stackOf, withLayer } from "./mapStack";

const file = (id: string) => ({ id, isOnByItself: true });
const online = (id: string) => ({ id, isOnByItself: false });

describe("the stack of layers", () => {
  test("shows new files at once and on top, and asks the internet for nothing by itself", () => {
    const remembered = rememberedStack([{ id: "a", isOn: false, opacity: 0.5 }], undefined);
    expect(stackOf([file("a"), file("b"), online("osm")], remembered)).toEqual([
      { id: "b", isOn: true, opacity: 1 },
      { id: "osm", isOn: false, opacity: 1 },
      { id: "a", isOn: false, opacity: 0.5 },
    ]);
  });

  test("keeps the place of a layer that is away", () => {
    const first = rememberedStack(
      [
        { id: "a", isOn: true, opacity: 0.5 },
        { id: "b", isOn: true, opacity: 1 },
      ],
      undefined,
    );
    const alone = stackOf([file("b")], first);
    expect(alone.map(({ id }) => id)).toEqual(["b"]);
    const later = rememberedStack(withLayer(alone, "b", { opacity: 0.2 }), first);
    expect(stackOf([file("a"), file("b")], later)).toEqual([
      { id: "b", isOn: true, opacity: 0.2 },
      { id: "a", isOn: true, opacity: 0.5 },
    ]);
  });

  test("moves a layer up and down, not beyond its ends", () => {
    const stack = stackOf([file("a"), file("b"), file("c")], undefined);
    expect(movedLayer(stack, "c", -1).map(({ id }) => id)).toEqual(["a", "c", "b"]);
    expect(movedLayer(stack, "a", -1)).toBe(stack);
    expect(movedLayer(stack, "c", 1)).toBe(stack);
    expect(movedLayer(stack, "none", 1)).toBe(stack);
  });

  test.each(["{", "3", '[["a"]]', '[["a", true, 7]]', "[[1, true, 1]]"])(
    "begins anew where what is remembered is %s",
    (remembered) => {
      expect(stackOf([file("a")], remembered)).toEqual([{ id: "a", isOn: true, opacity: 1 }]);
    },
  );
});

describe("the address of an online source", () => {
  test("is good with its three numbers and https", () => {
    expect(addressFault("https://tile.openstreetmap.org/{z}/{x}/{y}.png")).toBeNull();
    expect(addressFault("https://maps.example/wmts?x={x}&y={y}&z={z}")).toBeNull();
  });

  test.each([
    ["http://tile.example/{z}/{x}/{y}.png", "scheme"],
    ["tile.example/{z}/{x}/{y}.png", "scheme"],
    ["https://tile.example/{z}/{x}.png", "places"],
    ["https://tile.example/{z}/{x}/{y}/{y}.png", "places"],
    ["https:// tile/{z}/{x}/{y}", "unreadable"],
  ])("%s is refused", (url, fault) => {
    expect(addressFault(url)).toBe(fault);
  });
});

test.each([
  ["OpenStreetMap", "openstreetmap"],
  ["PNOA máxima (2024)", "pnoa-maxima-2024"],
  ["¡!", ""],
])("the id of %s is '%s'", (name, id) => {
  expect(sourceId(name)).toBe(id);
});
