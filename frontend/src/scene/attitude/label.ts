import { CanvasTexture, LinearFilter, Sprite, SpriteMaterial } from "three";

const FONT_PX = 44;
const PAD_PX = 8;

/** A label that always faces the camera, in the scene's units: a plate behind it keeps it legible over anything. */
export class Label {
  readonly sprite: Sprite;
  readonly #material: SpriteMaterial;
  readonly #height: number;
  #texture: CanvasTexture | null = null;
  #told = "";

  constructor(height: number) {
    this.#height = height;
    this.#material = new SpriteMaterial({ transparent: true, depthTest: false, depthWrite: false });
    this.sprite = new Sprite(this.#material);
    this.sprite.renderOrder = 10;
  }

  write(text: string, ink: string, plate: string): void {
    const told = `${text} ${ink} ${plate}`;
    if (told === this.#told) {
      return;
    }
    this.#told = told;
    const canvas = document.createElement("canvas");
    const context = canvas.getContext("2d");
    if (context === null) {
      return;
    }
    const font = `600 ${FONT_PX}px "Inter Variable", Inter, system-ui, sans-serif`;
    context.font = font;
    canvas.width = Math.ceil(context.measureText(text).width) + 2 * PAD_PX;
    canvas.height = Math.round(1.25 * FONT_PX) + PAD_PX;
    context.font = font;
    context.globalAlpha = 0.7;
    context.fillStyle = plate;
    context.fillRect(0, 0, canvas.width, canvas.height);
    context.globalAlpha = 1;
    context.fillStyle = ink;
    context.textAlign = "center";
    context.textBaseline = "middle";
    context.fillText(text, canvas.width / 2, canvas.height / 2 + 2);
    this.#texture?.dispose();
    this.#texture = new CanvasTexture(canvas);
    this.#texture.minFilter = LinearFilter;
    this.#texture.generateMipmaps = false;
    this.#texture.colorSpace = "srgb";
    this.#material.map = this.#texture;
    this.#material.needsUpdate = true;
    this.sprite.scale.set((this.#height * canvas.width) / canvas.height, this.#height, 1);
  }

  dispose(): void {
    this.#texture?.dispose();
    this.#material.dispose();
  }
}
