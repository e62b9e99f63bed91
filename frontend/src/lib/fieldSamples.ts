import type { Vector } from "./attitude";
import { corrected, type FieldFit } from "./ellipsoid";

/** A reading nearer than this to a kept one is dropped; of a field of about one some 800 are kept. */
const SPACING = 0.12;
/** Greatest number of kept readings, whatever a broken sensor sends. */
export const MOST_SAMPLES = 1000;

/** Magnetometer readings, evenly spread over the directions, however long the board rests in one. */
export class FieldSamples {
  #points: Vector[] = [];
  #cleared: Vector[] | null = null;
  #revision = 0;

  get points(): readonly Vector[] {
    return this.#points;
  }

  /** Changes with each change of the readings. */
  get revision(): number {
    return this.#revision;
  }

  get canRestore(): boolean {
    return this.#cleared !== null;
  }

  /** Returns whether it was kept. */
  add(reading: Vector): boolean {
    if (this.#points.length >= MOST_SAMPLES || !reading.every(Number.isFinite)) {
      return false;
    }
    const [x, y, z] = reading;
    for (const [a, b, c] of this.#points) {
      if ((x - a) ** 2 + (y - b) ** 2 + (z - c) ** 2 < SPACING * SPACING) {
        return false;
      }
    }
    this.#points.push(reading);
    this.#cleared = null;
    this.#revision += 1;
    return true;
  }

  clear(): void {
    this.#cleared = this.#points.length > 0 ? this.#points : this.#cleared;
    this.#points = [];
    this.#revision += 1;
  }

  /** Undo the last clearing, if nothing was collected since. */
  restore(): void {
    if (this.#cleared !== null) {
      this.#points = this.#cleared;
      this.#cleared = null;
      this.#revision += 1;
    }
  }
}

/** Significant digits, more than any of these sensors resolves. */
const FIGURES = 5;

function figures(values: readonly number[]): string {
  return values.map((value) => value.toFixed(FIGURES)).join(", ");
}

/** The calibration as text, to paste into a program. */
export function fitText({ offset, matrix, radius, residual }: FieldFit): string {
  return [
    `offset = [${figures(offset)}]`,
    `scale = [${figures([matrix[0][0], matrix[1][1], matrix[2][2]])}]`,
    `soft_iron = [[${matrix.map(figures).join("], [")}]]`,
    `field = ${radius.toFixed(FIGURES)}`,
    `residual_rms = ${residual.toFixed(FIGURES)}`,
    "",
  ].join("\n");
}

/** The readings and, if there is a fit, the corrected ones. */
export function samplesCsv(points: readonly Vector[], fit: FieldFit | null): string {
  const rows = points.map((point) => {
    const made = fit === null ? ["", "", ""] : corrected(fit, point).map((value) => value.toFixed(FIGURES));
    return [...point.map((value) => value.toFixed(FIGURES)), ...made].join(",");
  });
  return ["magx,magy,magz,corrected_x,corrected_y,corrected_z", ...rows, ""].join("\r\n");
}
