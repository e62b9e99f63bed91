/**
 * Without a graphics processor the browser reads back a visible WebGL canvas before it goes on, and the whole page
 * freezes until it is drawn. So the WebGL canvas is hidden, and each finished picture is copied to this one.
 */
export class CopiedPicture {
  readonly canvas = document.createElement("canvas");
  readonly #source: HTMLCanvasElement;
  readonly #context: CanvasRenderingContext2D | null;

  /** `isClear`: where the source is transparent, what lies behind is seen. */
  constructor(source: HTMLCanvasElement, isClear = false) {
    this.#source = source;
    // In main memory, from which the page is composed.
    this.#context = this.canvas.getContext("2d", { alpha: isClear, willReadFrequently: true });
  }

  copy(): void {
    const { canvas } = this;
    const { width, height } = this.#source;
    if (canvas.width !== width || canvas.height !== height) {
      [canvas.width, canvas.height] = [width, height];
    }
    if (this.#context !== null) {
      // A canvas that was resized has forgotten how it draws.
      this.#context.globalCompositeOperation = "copy";
      this.#context.drawImage(this.#source, 0, 0);
    }
  }
}
