import { expect, test } from "vitest";
import { airframeFaces, shadeOf } from "./airframe";
import { gltfAddress } from "./gltf";

function decoded(address: string): Uint8Array<ArrayBuffer> {
  return Uint8Array.from(atob(address.slice(address.indexOf(",") + 1)), (letter) => letter.charCodeAt(0));
}

interface Document {
  accessors: { count: number; min?: number[]; max?: number[] }[];
  bufferViews: { byteOffset: number; byteLength: number }[];
  buffers: { byteLength: number; uri: string }[];
}

const faces = airframeFaces();
const document = JSON.parse(new TextDecoder().decode(decoded(gltfAddress(faces)))) as Document;
const bytes = decoded(document.buffers[0]?.uri ?? "");
const [positions, colours] = document.bufferViews.map(
  ({ byteOffset, byteLength }) => new Float32Array(bytes.buffer, byteOffset, byteLength / 4),
);

test("the file holds as many corners as it says, three to a triangle, each with a place and a colour", () => {
  const count = document.accessors[0]?.count ?? 0;
  expect(count % 3).toBe(0);
  expect(positions?.length).toBe(3 * count);
  expect(colours?.length).toBe(3 * count);
  expect(bytes.byteLength).toBe(document.buffers[0]?.byteLength);
});

test("its bounds are those of its corners", () => {
  const ahead = Array.from(positions ?? []).filter((_, index) => index % 3 === 2);
  expect(document.accessors[0]?.min?.[2]).toBe(Math.min(...ahead));
  expect(document.accessors[0]?.max?.[2]).toBe(Math.max(...ahead));
});

test("the nose is ahead, the fin behind and up, and the green tip on the right", () => {
  const points = Array.from({ length: (positions?.length ?? 0) / 3 }, (_, index) => ({
    left: positions?.[3 * index] ?? 0,
    up: positions?.[3 * index + 1] ?? 0,
    ahead: positions?.[3 * index + 2] ?? 0,
    green: (colours?.[3 * index + 1] ?? 0) > 2 * (colours?.[3 * index] ?? 0),
  }));
  const top = points.reduce((highest, point) => (point.up > highest.up ? point : highest));
  expect(top.ahead).toBeLessThan(-0.8);
  expect(Math.max(...points.map(({ ahead }) => ahead))).toBeGreaterThan(1);
  const green = points.filter((point) => point.green);
  expect(green.length).toBeGreaterThan(0);
  expect(green.every(({ left }) => left < -1)).toBe(true);
});

test("what looks up is lighter than what looks down", () => {
  const above = faces.filter(({ outwards }) => outwards[2] > 0 && outwards[0] === 0 && outwards[1] === 0);
  const below = faces.filter(({ outwards }) => outwards[2] < 0 && outwards[0] === 0 && outwards[1] === 0);
  expect(above.length).toBeGreaterThan(4);
  expect(Math.min(...above.map(shadeOf))).toBeGreaterThan(0.85);
  expect(Math.max(...below.map(shadeOf))).toBeLessThan(0.5);
});
