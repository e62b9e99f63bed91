/**
 * Where the processor draws alone, the browser reads a shown WebGL picture back before it goes on, and the page and its
 * instruments would stand still until it is drawn. There the picture itself is not seen (it still takes the pointer's
 * presses), and each finished one is copied onto this.
 */
export class CopiedPicture {
  readonly #source: HTMLCanvasElement;
  readonly #context: CanvasRenderingContext2D | null;

  constructor(source: HTMLCanvasElement) {
    const canvas = document.createElement("canvas");
    // In the processor's own memory, from where the page is put together.
    this.#context = canvas.getContext("2d", { alpha: false, willReadFrequently: true });
    this.#source = source;
    canvas.className = "globe-picture";
    source.before(canvas);
    source.classList.remove("globe-picture");
    source.classList.add("globe-unseen");
  }

  copy(): void {
    if (this.#context === null) {
      return;
    }
    const { canvas } = this.#context;
    const { width, height } = this.#source;
    if (canvas.width !== width || canvas.height !== height) {
      [canvas.width, canvas.height] = [width, height];
    }
    this.#context.drawImage(this.#source, 0, 0);
  }
}
