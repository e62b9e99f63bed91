import {
  BlendingState,
  type BoundingSphere,
  Buffer,
  BufferUsage,
  DrawCommand,
  IndexDatatype,
  Pass,
  type PictureState,
  PrimitiveType,
  type RendererContext,
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

/** The style of a line. */
export interface RibbonStyle {
  readonly line: Uniforms;
  readonly isDashed: boolean;
  /** Whether it is translucent. */
  readonly isTranslucent: boolean;
  /** Null: without a curtain. */
  readonly curtain: {
    readonly uniforms: Uniforms;
    /** A bit of the stencil buffer, for this curtain alone. */
    readonly veil: number;
  } | null;
}

export type RibbonPart = "line" | "curtain";

const LOCATIONS = { fromCoarse: 0, fromFine: 1, fromRates: 2, toCoarse: 3, toFine: 4, toRates: 5 };
const CORNER_BYTES = CORNERS * POINT_BYTES;

/**
 * A line of points, optionally with a curtain. The points are in one buffer on the graphics processor, each once per
 * corner of the rectangle to the next point, and all rectangles are drawn in one call. (As instances of one rectangle
 * they took a quarter of the memory, but without a graphics processor each instance is drawn separately.)
 */
export class Ribbon {
  readonly #style: RibbonStyle;
  readonly #sphere: BoundingSphere;
  #parts: Parts | null = null;
  #count = 0;
  #vertices: Float32Array = new Float32Array(0);
  /** Index of the first point that is not yet on the graphics processor. */
  #waiting = Number.POSITIVE_INFINITY;

  /** `sphere`: contains all that is drawn of it; may change. */
  constructor(style: RibbonStyle, sphere: BoundingSphere) {
    this.#style = style;
    this.#sphere = sphere;
  }

  /**
   * From the next picture on, the line is the first `count` points of `vertices`; those before `first` are unchanged.
   */
  set(vertices: Float32Array, count: number, first = 0): void {
    this.#vertices = vertices;
    this.#waiting = Math.min(this.#waiting, first);
    this.#count = count;
  }

  /** Draw only these stretches, by the indices of their first points; by default all. */
  draw(state: PictureState, part: RibbonPart, ranges?: readonly Range[]): void {
    if (this.#count < 2) {
      return;
    }
    const parts = this.#upload(state.context);
    for (const [index, { begin, end }] of (ranges ?? [{ begin: 0, end: this.#count - 1 }]).entries()) {
      const command = parts.command(part, index);
      if (command !== null) {
        command.offset = begin * INDICES;
        command.count = (end - begin) * INDICES;
        state.commandList.push(command);
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

/** Points are uploaded in groups of this size. */
const PIECE = 512;
const piece = new Float32Array(PIECE * CORNERS * POINT_FLOATS);

/** How one part is drawn, with one command per stretch, reused in the next picture. */
interface PartDrawing {
  readonly program: ShaderProgram;
  readonly uniformMap: Uniforms;
  readonly renderState: RenderState;
  readonly commands: DrawCommand[];
}

/** The graphics processor's buffers for a line of at most this many points. */
class Parts {
  readonly capacity: number;
  readonly points: Buffer;
  readonly #sphere: BoundingSphere;
  readonly #vertexArray: VertexArray;
  readonly #drawings: Readonly<Record<RibbonPart, PartDrawing | null>>;

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

  /** The command of the picture's `index`-th stretch; null if the line has no such part. */
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
      // Also for the curtain: labels are drawn over it, and what is drawn later shows through it unchanged.
      pass: Pass.OPAQUE,
      boundingVolume: this.#sphere,
    });
    return drawing.commands[index];
  }

  destroy(): void {
    // Destroys its buffers too.
    this.#vertexArray.destroy();
    for (const drawing of Object.values(this.#drawings)) {
      drawing?.program.destroy();
    }
  }
}

/** Each pixel is drawn once: the curtains of many rounds look like one, and cost as one. */
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

/** Each corner reads two neighbours from the one buffer of points: its own, and the next. */
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
