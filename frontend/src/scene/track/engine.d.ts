/**
 * The part of Cesium's renderer that draws the track. The engine exports it and leaves it out of its own types, for it
 * may change with a version; ours is pinned, and the layer's test in a browser draws with it.
 */
declare module "@cesium/engine" {
  export interface RendererContext {
    readonly drawingBufferWidth: number;
    readonly drawingBufferHeight: number;
  }

  export interface RendererFrame {
    readonly context: RendererContext;
    readonly passes: { readonly render: boolean };
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

  export class ShaderProgram {
    static fromCache(options: {
      context: RendererContext;
      vertexShaderSource: string;
      fragmentShaderSource: string;
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
    count: number;
    boundingVolume: BoundingSphere;
    vertexArray: VertexArray;
  }
}
