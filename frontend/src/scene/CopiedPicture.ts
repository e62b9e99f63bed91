/**
 * Where the processor draws alone, the browser reads a shown WebGL picture back before it goes on, and the page and its
 * instruments would stand still until it is drawn. There the picture itself is not seen, and each finished one is copied
 * onto this.
 */
export class CopiedPicture {
  readonly canvas = document.createElement("canvas");
  readonly #source: HTMLCanvasElement;
  readonly #context: CanvasRenderingContext2D | null;

  constructor(source: HTMLCanvasElement) {
    this.#source = source;
    // In the processor's own memory, from where the page is put together.
    this.#context = this.canvas.getContext("2d", { alpha: false, willReadFrequently: true });
  }

  copy(): void {
    const { canvas } = this;
    const { width, height } = this.#source;
    if (canvas.width !== width || canvas.height !== height) {
      [canvas.width, canvas.height] = [width, height];
    }
    this.#context?.drawImage(this.#source, 0, 0);
  }
}
