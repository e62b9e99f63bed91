import { type Face, shadeOf } from "./airframe";

const FLOAT = 5126;
const TRIANGLES = 4;
const VERTICES = 34_962;

/**
 * Faces as a one-file glTF 2.0 in a data address: metres, nose to +z, up +y, so the right wing is at -x. The corners'
 * colours include the light: the material ignores the scene's lights.
 */
export function gltfAddress(faces: readonly Face[]): string {
  const corners = faces.flatMap((face) => {
    const shade = shadeOf(face);
    const colour = face.colour.map((part) => part * shade);
    // A triangle fan from the first corner.
    return face.corners.slice(2).flatMap((third, index) =>
      [face.corners[0] ?? third, face.corners[index + 1] ?? third, third].map(([ahead, right, up]) => ({
        position: [-right, up, ahead],
        colour,
      })),
    );
  });
  const positions = new Float32Array(corners.flatMap(({ position }) => position));
  const colours = new Float32Array(corners.flatMap(({ colour }) => colour));
  const bytes = new Uint8Array(positions.byteLength + colours.byteLength);
  bytes.set(new Uint8Array(positions.buffer), 0);
  bytes.set(new Uint8Array(colours.buffer), positions.byteLength);
  const axis = (index: number): number[] => corners.map(({ position }) => Math.fround(position[index] ?? 0));
  const document = {
    asset: { version: "2.0" },
    extensionsUsed: ["KHR_materials_unlit"],
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [{ mesh: 0 }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0, COLOR_0: 1 }, material: 0, mode: TRIANGLES }] }],
    materials: [
      {
        doubleSided: true,
        pbrMetallicRoughness: { metallicFactor: 0, roughnessFactor: 1 },
        extensions: { KHR_materials_unlit: {} },
      },
    ],
    accessors: [
      {
        bufferView: 0,
        componentType: FLOAT,
        count: corners.length,
        type: "VEC3",
        min: [0, 1, 2].map((index) => axis(index).reduce((least, part) => Math.min(least, part))),
        max: [0, 1, 2].map((index) => axis(index).reduce((most, part) => Math.max(most, part))),
      },
      { bufferView: 1, componentType: FLOAT, count: corners.length, type: "VEC3" },
    ],
    bufferViews: [
      { buffer: 0, byteOffset: 0, byteLength: positions.byteLength, target: VERTICES },
      { buffer: 0, byteOffset: positions.byteLength, byteLength: colours.byteLength, target: VERTICES },
    ],
    buffers: [{ byteLength: bytes.byteLength, uri: `data:application/octet-stream;base64,${base64(bytes)}` }],
  };
  return `data:model/gltf+json;base64,${base64(new TextEncoder().encode(JSON.stringify(document)))}`;
}

function base64(bytes: Uint8Array): string {
  let text = "";
  for (const byte of bytes) {
    text += String.fromCharCode(byte);
  }
  return btoa(text);
}
