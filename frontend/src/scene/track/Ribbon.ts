import {
  BlendingState,
  type BoundingSphere,
  Buffer,
  BufferUsage,
  DrawCommand,
  IndexDatatype,
  Pass,
  PrimitiveType,
  type RendererContext,
  type RendererFrame,
  RenderState,
  ShaderProgram,
  StencilFunction,
  StencilOperation,
  VertexArray,
} from "@cesium/engine";
import { CORNERS, cornerIndices, INDICES, spread } from "./quads";
import { CURTAIN_FRAGMENT, CURTAIN_VERTEX, LINE_FRAGMENT, LINE_VERTEX } from "./shaders";
import { POINT_BYTES, POINT_FLOATS } from "./vertices";

type Uniforms = Readonly<Record<string, () => unknown>>;

/** What all lines look like. */
export interface RibbonStyle {
  readonly casing: Uniforms;
  readonly line: Uniforms;
  readonly curtain: Uniforms;
  /** A bit of the picture's stencil, for this track alone. */
  readonly veil: number;
}

/** What is drawn of a line, in this order. */
export type RibbonPart = "casing" | "line" | "curtain";

const LOCATIONS = { fromCoarse: 0, fromFine: 1, fromRates: 2, toCoarse: 3, toFine: 4, toRates: 5 };
const CORNER_BYTES = CORNERS * POINT_BYTES;

/**
 * A line of points with its curtain. The points lie in one buffer on the graphics processor, each once for every corner
 * of the rectangle from it to the next one, and all rectangles are drawn at once. (As copies of one rectangle they took
 * a quarter of the room, but where the processor draws alone each copy is a drawing of its own.)
 */
export class Ribbon {
  readonly #style: RibbonStyle;
  readonly #sphere: BoundingSphere;
  #parts: Parts | null = null;
  #count = 0;
  #vertices: Float32Array = new Float32Array(0);
  /** From this point on they are not on the graphics processor yet. */
  #waiting = Number.POSITIVE_INFINITY;

  constructor(style: RibbonStyle, sphere: BoundingSphere) {
    this.#style = style;
    this.#sphere = sphere;
  }

  /** The first `count` points of `vertices` are the line from the next frame on; those before `first` are as they were. */
  set(vertices: Float32Array, count: number, first = 0): void {
    this.#vertices = vertices;
    this.#waiting = Math.min(this.#waiting, first);
    this.#count = count;
  }

  draw(frame: RendererFrame, part: RibbonPart): void {
    if (this.#count < 2) {
      return;
    }
    const command = this.#upload(frame.context).commands[part];
    command.count = (this.#count - 1) * INDICES;
    command.boundingVolume = this.#sphere;
    frame.commandList.push(command);
  }

  destroy(): void {
    this.#parts?.destroy();
    this.#parts = null;
  }

  #upload(context: RendererContext): Parts {
    if (this.#parts === null || this.#parts.capacity < this.#count) {
      this.#parts?.destroy();
      this.#parts = new Parts(context, Math.ceil(this.#count * 1.5), this.#style, this.#sphere);
      this.#waiting = 0;
    }
    for (let first = this.#waiting; first < this.#count; first += PIECE) {
      const points = this.#vertices.subarray(
        first * POINT_FLOATS,
        Math.min(this.#count, first + PIECE) * POINT_FLOATS,
      );
      this.#parts.points.copyFromArrayView(spread(points, piece), first * CORNER_BYTES);
    }
    this.#waiting = Number.POSITIVE_INFINITY;
    return this.#parts;
  }
}

/** Points are handed to the graphics processor so many at a time. */
const PIECE = 512;
const piece = new Float32Array(PIECE * CORNERS * POINT_FLOATS);

/** What lies on the graphics processor for a line of at most so many points. */
class Parts {
  readonly capacity: number;
  readonly points: Buffer;
  readonly commands: Readonly<Record<RibbonPart, DrawCommand>>;
  readonly #vertexArray: VertexArray;
  readonly #programs: readonly ShaderProgram[];

  constructor(context: RendererContext, capacity: number, style: RibbonStyle, sphere: BoundingSphere) {
    this.capacity = capacity;
    this.points = Buffer.createVertexBuffer({
      context,
      sizeInBytes: capacity * CORNER_BYTES,
      usage: BufferUsage.DYNAMIC_DRAW,
    });
    this.#vertexArray = vertexArrayOf(context, this.points, capacity);
    const program = (vertexShaderSource: string, fragmentShaderSource: string): ShaderProgram =>
      ShaderProgram.fromCache({
        context,
        vertexShaderSource,
        fragmentShaderSource,
        attributeLocations: LOCATIONS,
      });
    const line = program(LINE_VERTEX, LINE_FRAGMENT);
    const curtain = program(CURTAIN_VERTEX, CURTAIN_FRAGMENT);
    this.#programs = [line, curtain];
    const command = (shaderProgram: ShaderProgram, uniformMap: Uniforms, state: object) =>
      new DrawCommand({
        owner: this,
        primitiveType: PrimitiveType.TRIANGLES,
        vertexArray: this.#vertexArray,
        count: 0,
        shaderProgram,
        uniformMap,
        renderState: RenderState.fromCache(state),
        // Also the curtain: names are written over it, and what is drawn after it is seen through it unveiled.
        pass: Pass.OPAQUE,
        boundingVolume: sphere,
      });
    const depthTest = { enabled: true };
    this.commands = {
      // Leaves no depth: the line itself is drawn over it.
      casing: command(line, style.casing, { depthTest, depthMask: false }),
      line: command(line, style.line, { depthTest, depthMask: true }),
      curtain: command(curtain, style.curtain, {
        depthTest,
        depthMask: false,
        blending: BlendingState.ALPHA_BLEND,
        ...onceEach(style.veil),
      }),
    };
  }

  destroy(): void {
    // Takes its buffers along.
    this.#vertexArray.destroy();
    for (const program of this.#programs) {
      program.destroy();
    }
  }
}

/** Each point of the picture once: the curtains of many rounds over each other stay one veil, and cost as one. */
function onceEach(bit: number): object {
  const operation = { zPass: StencilOperation.REPLACE };
  return {
    stencilMask: bit,
    stencilTest: {
      enabled: true,
      frontFunction: StencilFunction.NOT_EQUAL,
      backFunction: StencilFunction.NOT_EQUAL,
      frontOperation: operation,
      backOperation: operation,
      reference: bit,
      mask: bit,
    },
  };
}

/** Each corner takes two neighbours out of the one buffer of points: its own, and the one that follows. */
function vertexArrayOf(context: RendererContext, points: Buffer, capacity: number): VertexArray {
  const attribute = (index: number, componentsPerAttribute: number, offsetInBytes: number) => ({
    index,
    vertexBuffer: points,
    componentsPerAttribute,
    offsetInBytes,
    strideInBytes: POINT_BYTES,
  });
  return new VertexArray({
    context,
    attributes: [
      attribute(LOCATIONS.fromCoarse, 4, 0),
      attribute(LOCATIONS.fromFine, 4, 16),
      attribute(LOCATIONS.fromRates, 2, 32),
      attribute(LOCATIONS.toCoarse, 4, CORNER_BYTES),
      attribute(LOCATIONS.toFine, 4, CORNER_BYTES + 16),
      attribute(LOCATIONS.toRates, 2, CORNER_BYTES + 32),
    ],
    indexBuffer: Buffer.createIndexBuffer({
      context,
      typedArray: cornerIndices(capacity - 1),
      usage: BufferUsage.STATIC_DRAW,
      indexDatatype: IndexDatatype.UNSIGNED_INT,
    }),
  });
}
