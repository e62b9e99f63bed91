import {
  BlendingState,
  type BoundingSphere,
  Buffer,
  BufferUsage,
  DrawCommand,
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

const CORNERS = new Float32Array([0, -1, 0, 1, 1, -1, 1, 1]);
const LOCATIONS = { corner: 0, fromCoarse: 1, fromFine: 2, fromRates: 3, toCoarse: 4, toFine: 5, toRates: 6 };

/**
 * A line of points with its curtain. The points lie in one buffer on the graphics processor, which draws the stretch
 * between each two of them as one copy of a rectangle: a point more is forty bytes more and nothing else.
 */
export class Ribbon {
  readonly #style: RibbonStyle;
  readonly #sphere: BoundingSphere;
  #parts: Parts | null = null;
  #count = 0;
  /** Points that are not on the graphics processor yet. */
  #waiting: Float32Array | null = null;

  constructor(style: RibbonStyle, sphere: BoundingSphere) {
    this.#style = style;
    this.#sphere = sphere;
  }

  /** The first `count` points of `vertices` are the line from the next frame on. */
  set(vertices: Float32Array, count: number): void {
    this.#waiting = vertices.subarray(0, count * POINT_FLOATS);
    this.#count = count;
  }

  draw(frame: RendererFrame, part: RibbonPart): void {
    if (this.#count < 2) {
      return;
    }
    const command = this.#upload(frame.context).commands[part];
    command.instanceCount = this.#count - 1;
    command.boundingVolume = this.#sphere;
    frame.commandList.push(command);
  }

  destroy(): void {
    this.#parts?.destroy();
    this.#parts = null;
  }

  #upload(context: RendererContext): Parts {
    const bytes = this.#count * POINT_BYTES;
    if (this.#parts === null || this.#parts.bytes < bytes) {
      this.#parts?.destroy();
      this.#parts = new Parts(context, Math.ceil(this.#count * 1.5) * POINT_BYTES, this.#style, this.#sphere);
    }
    if (this.#waiting !== null) {
      this.#parts.points.copyFromArrayView(this.#waiting);
      this.#waiting = null;
    }
    return this.#parts;
  }
}

/** What lies on the graphics processor for a line of at most so many bytes. */
class Parts {
  readonly bytes: number;
  readonly points: Buffer;
  readonly commands: Readonly<Record<RibbonPart, DrawCommand>>;
  readonly #vertexArray: VertexArray;
  readonly #programs: readonly ShaderProgram[];

  constructor(context: RendererContext, bytes: number, style: RibbonStyle, sphere: BoundingSphere) {
    this.bytes = bytes;
    this.points = Buffer.createVertexBuffer({
      context,
      sizeInBytes: bytes,
      usage: BufferUsage.DYNAMIC_DRAW,
    });
    const corners = Buffer.createVertexBuffer({
      context,
      typedArray: CORNERS,
      usage: BufferUsage.STATIC_DRAW,
    });
    this.#vertexArray = vertexArrayOf(context, corners, this.points);
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
        primitiveType: PrimitiveType.TRIANGLE_STRIP,
        vertexArray: this.#vertexArray,
        count: CORNERS.length / 2,
        instanceCount: 1,
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

/** Each copy of the rectangle takes two neighbours out of the one buffer of points. */
function vertexArrayOf(context: RendererContext, corners: Buffer, points: Buffer): VertexArray {
  const attribute = (index: number, componentsPerAttribute: number, offsetInBytes: number) => ({
    index,
    vertexBuffer: points,
    componentsPerAttribute,
    offsetInBytes,
    strideInBytes: POINT_BYTES,
    instanceDivisor: 1,
  });
  return new VertexArray({
    context,
    attributes: [
      { index: LOCATIONS.corner, vertexBuffer: corners, componentsPerAttribute: 2 },
      attribute(LOCATIONS.fromCoarse, 4, 0),
      attribute(LOCATIONS.fromFine, 4, 16),
      attribute(LOCATIONS.fromRates, 2, 32),
      attribute(LOCATIONS.toCoarse, 4, POINT_BYTES),
      attribute(LOCATIONS.toFine, 4, POINT_BYTES + 16),
      attribute(LOCATIONS.toRates, 2, POINT_BYTES + 32),
    ],
  });
}
