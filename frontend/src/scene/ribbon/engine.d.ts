/**
 * Cesium's renderer for lines. The engine exports it without types, because it may change between versions; our
 * version is pinned, and the layer's browser test draws with it.
 */
declare module "@cesium/engine" {
  export interface RendererContext {
    readonly drawingBufferWidth: number;
    readonly drawingBufferHeight: number;
  }

  export interface PictureState {
    readonly context: RendererContext;
    readonly passes: { readonly render: boolean };
    /** What the camera sees. */
    readonly cullingVolume: CullingVolume;
    readonly commandList: DrawCommand[];
  }

  export class Buffer {
    static createVertexBuffer(options: {
      context: RendererContext;
      usage: number;
      typedArray?: ArrayBufferView;
      sizeInBytes?: number;
    }): Buffer;
    static createIndexBuffer(options: {
      context: RendererContext;
      usage: number;
      typedArray: ArrayBufferView;
      indexDatatype: IndexDatatype;
    }): Buffer;
    readonly sizeInBytes: number;
    vertexArrayDestroyable: boolean;
    copyFromArrayView(view: ArrayBufferView, offsetInBytes?: number): void;
    destroy(): void;
  }

  export const BufferUsage: { readonly STATIC_DRAW: number; readonly DYNAMIC_DRAW: number };
  export const Pass: { readonly OPAQUE: number; readonly TRANSLUCENT: number };

  export class VertexArray {
    constructor(options: {
      context: RendererContext;
      attributes: ReadonlyArray<{
        index: number;
        vertexBuffer: Buffer;
        componentsPerAttribute: number;
        offsetInBytes?: number;
        strideInBytes?: number;
      }>;
      indexBuffer?: Buffer;
    });
    destroy(): void;
  }

  export class ShaderSource {
    constructor(options: { sources: readonly string[]; defines: readonly string[] });
  }

  export class ShaderProgram {
    static fromCache(options: {
      context: RendererContext;
      vertexShaderSource: string;
      fragmentShaderSource: ShaderSource;
      attributeLocations: Readonly<Record<string, number>>;
    }): ShaderProgram;
    destroy(): void;
  }

  export interface RenderState {
    readonly id: number;
  }
  export const RenderState: { readonly fromCache: (state: object) => RenderState };

  export class DrawCommand {
    constructor(options: {
      owner: object;
      primitiveType: PrimitiveType;
      vertexArray: VertexArray;
      count: number;
      shaderProgram: ShaderProgram;
      renderState: RenderState;
      uniformMap: Readonly<Record<string, () => unknown>>;
      pass: number;
      boundingVolume: BoundingSphere;
    });
    offset: number;
    count: number;
  }
}
