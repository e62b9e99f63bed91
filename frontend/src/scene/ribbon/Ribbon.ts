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
  ShaderSource,
  StencilFunction,
  StencilOperation,
  VertexArray,
} from "@cesium/engine";
import { CORNERS, cornerIndices, INDICES, spread } from "./quads";
import type { Range } from "./ranges";
import {
  CURTAIN_DEFINES,
  CURTAIN_FRAGMENT,
  CURTAIN_VERTEX,
  DASHED_DEFINES,
  LINE_FRAGMENT,
  LINE_VERTEX,
} from "./shaders";
import { POINT_BYTES, POINT_FLOATS } from "./vertices";

type Uniforms = Readonly<Record<string, () => unknown>>;

/** What a line looks like. */
export interface RibbonStyle {
  readonly line: Uniforms;
  readonly isDashed: boolean;
  /** What is behind it shines through. */
  readonly isTranslucent: boolean;
  /** Null: it has none. */
  readonly curtain: {
    readonly uniforms: Uniforms;
    /** A bit of the picture's stencil, for this curtain alone. */
    readonly veil: number;
  } | null;
}

export type RibbonPart = "line" | "curtain";

const LOCATIONS = { fromCoarse: 0, fromFine: 1, fromRates: 2, toCoarse: 3, toFine: 4, toRates: 5 };
const CORNER_BYTES = CORNERS * POINT_BYTES;

/**
 * A line of points, with a curtain where it has one. The points lie in one buffer on the graphics processor, each once
 * for every corner of the rectangle from it to the next one, and all rectangles are drawn at once. (As copies of one
 * rectangle they took a quarter of the room, but where the processor draws alone each copy is a drawing of its own.)
 */
export class Ribbon {
  readonly #style: RibbonStyle;
  readonly #sphere: BoundingSphere;
  #parts: Parts | null = null;
  #count = 0;
  #vertices: Float32Array = new Float32Array(0);
  /** From this point on they are not on the graphics processor yet. */
  #waiting = Number.POSITIVE_INFINITY;

  /** `sphere`: holds all that is drawn of it; may change. */
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

  /** Only these stretches of it, counted by the points they begin with; all where nothing is said. */
  draw(frame: RendererFrame, part: RibbonPart, ranges?: readonly Range[]): void {
    if (this.#count < 2) {
      return;
    }
    const parts = this.#upload(frame.context);
    for (const [index, { begin, end }] of (ranges ?? [{ begin: 0, end: this.#count - 1 }]).entries()) {
      const command = parts.command(part, index);
      if (command !== null) {
        command.offset = begin * INDICES;
        command.count = (end - begin) * INDICES;
        frame.commandList.push(command);
      }
    }
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

/** How one part is drawn, and the commands for it: one for each stretch of a frame, kept for the next. */
interface Drawing {
  readonly program: ShaderProgram;
  readonly uniformMap: Uniforms;
  readonly renderState: RenderState;
  readonly commands: DrawCommand[];
}

/** What lies on the graphics processor for a line of at most so many points. */
class Parts {
  readonly capacity: number;
  readonly points: Buffer;
  readonly #sphere: BoundingSphere;
  readonly #vertexArray: VertexArray;
  readonly #drawings: Readonly<Record<RibbonPart, Drawing | null>>;

  constructor(context: RendererContext, capacity: number, style: RibbonStyle, sphere: BoundingSphere) {
    this.capacity = capacity;
    this.#sphere = sphere;
    this.points = Buffer.createVertexBuffer({
      context,
      sizeInBytes: capacity * CORNER_BYTES,
      usage: BufferUsage.DYNAMIC_DRAW,
    });
    this.#vertexArray = vertexArrayOf(context, this.points, capacity);
    const drawing = (vertexShaderSource: string, fragment: string, defines: readonly string[]) => ({
      program: ShaderProgram.fromCache({
        context,
        vertexShaderSource,
        fragmentShaderSource: new ShaderSource({ sources: [fragment], defines }),
        attributeLocations: LOCATIONS,
      }),
      commands: [],
    });
    const depthTest = { enabled: true };
    const blending = BlendingState.ALPHA_BLEND;
    const { line, isDashed, isTranslucent, curtain } = style;
    this.#drawings = {
      line: {
        ...drawing(LINE_VERTEX, LINE_FRAGMENT, isDashed ? DASHED_DEFINES : []),
        uniformMap: line,
        renderState: RenderState.fromCache({
          depthTest,
          depthMask: true,
          ...(isTranslucent && { blending }),
        }),
      },
      curtain: curtain && {
        ...drawing(CURTAIN_VERTEX, CURTAIN_FRAGMENT, CURTAIN_DEFINES),
        uniformMap: curtain.uniforms,
        renderState: RenderState.fromCache({
          depthTest,
          depthMask: false,
          blending,
          ...onceEach(curtain.veil),
        }),
      },
    };
  }

  /** That of the frame's `index`-th stretch; null where the line has no such part. */
  command(part: RibbonPart, index: number): DrawCommand | null {
    const drawing = this.#drawings[part];
    if (drawing === null) {
      return null;
    }
    drawing.commands[index] ??= new DrawCommand({
      owner: this,
      primitiveType: PrimitiveType.TRIANGLES,
      vertexArray: this.#vertexArray,
      count: 0,
      shaderProgram: drawing.program,
      uniformMap: drawing.uniformMap,
      renderState: drawing.renderState,
      // Also the curtain: names are written over it, and what is drawn after it is seen through it unveiled.
      pass: Pass.OPAQUE,
      boundingVolume: this.#sphere,
    });
    return drawing.commands[index];
  }

  destroy(): void {
    // Takes its buffers along.
    this.#vertexArray.destroy();
    for (const drawing of Object.values(this.#drawings)) {
      drawing?.program.destroy();
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
