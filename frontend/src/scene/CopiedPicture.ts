/**
 * Without a graphics processor the browser reads back a visible WebGL canvas before it goes on, and the whole page
 * freezes until it is drawn. So the WebGL canvas is hidden, and each finished picture is copied to this one.
 */
export class CopiedPicture {
  readonly canvas = document.createElement("canvas");
  readonly #source: HTMLCanvasElement;
  readonly #context: CanvasRenderingContext2D | null;

  constructor(source: HTMLCanvasElement) {
    this.#source = source;
    // In main memory, from which the page is composed.
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
