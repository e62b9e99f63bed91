import type { Globe } from "../globe/Globe";
import type { ImageryHandle, ImagerySource } from "../globe/ground";

/** A visible image layer. */
export interface ShownLayer extends ImagerySource {
  readonly id: string;
  readonly opacity: number;
}

/** The user's layers on the ground. Unchanged layers are not loaded again. */
export class LayerStack {
  readonly #globe: Globe;
  #shown: readonly { readonly layer: ShownLayer; readonly handle: ImageryHandle }[] = [];
  #terrain: string | null = null;

  constructor(globe: Globe) {
    this.#globe = globe;
  }

  /** Show exactly these, from the topmost down. */
  show(layers: readonly ShownLayer[]): void {
    const fromBelow = [...layers].reverse();
    // Layers can only be added on top: all below the first changed one can stay.
    const same = fromBelow.findIndex((layer, index) => this.#shown[index]?.layer.id !== layer.id);
    const kept = same === -1 ? fromBelow.length : same;
    for (const { handle } of this.#shown.slice(kept)) {
      handle.remove();
    }
    this.#shown = fromBelow.map((layer, index) => {
      const handle = index < kept ? (this.#shown[index]?.handle ?? this.#add(layer)) : this.#add(layer);
      if (layer.opacity !== this.#shown[index]?.layer.opacity || index >= kept) {
        handle.setOpacity(layer.opacity);
      }
      return { layer, handle };
    });
  }

  /** Show the terrain of this address; null: none. Rejects if it cannot be read, and then there is none. */
  async showTerrain(url: string | null): Promise<void> {
    if (url === this.#terrain) {
      return;
    }
    this.#terrain = url;
    try {
      await this.#globe.ground.setTerrain(url === null ? null : { url });
    } catch (error) {
      if (url === this.#terrain) {
        this.#terrain = null;
        await this.#globe.ground.setTerrain(null);
        throw error;
      }
    }
  }

  dispose(): void {
    this.show([]);
  }

  #add(layer: ShownLayer): ImageryHandle {
    return this.#globe.ground.addImagery(layer);
  }
}
