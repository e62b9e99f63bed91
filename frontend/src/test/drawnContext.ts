/** A place of the picture, in its pixels. */
export interface DrawnPoint {
  readonly x: number;
  readonly y: number;
}

/** One thing that was drawn, as it lies on the picture. */
export interface Stroke {
  readonly kind: "rectangle" | "fill" | "stroke" | "text";
  /** Corners, or the lines of a path one by one. */
  readonly lines: ReadonlyArray<readonly DrawnPoint[]>;
  readonly colour: string;
  readonly alpha: number;
  /** Of a line, in pixels. */
  readonly width_px: number;
  readonly text: string;
  /** In which direction its writing runs, degrees clockwise from the right. */
  readonly turn_deg: number;
  /** The path itself; null: there was none. */
  readonly path: DrawnPath | null;
  readonly rule: string;
}

/** x' = a x + c y + e, y' = b x + d y + f. */
type Turn = readonly [a: number, b: number, c: number, d: number, e: number, f: number];
const STRAIGHT: Turn = [1, 0, 0, 1, 0, 0];

function times([a, b, c, d, e, f]: Turn, [g, h, i, j, k, l]: Turn): Turn {
  return [a * g + c * h, b * g + d * h, a * i + c * j, b * i + d * j, a * k + c * l + e, b * k + d * l + f];
}

function moved([a, b, c, d, e, f]: Turn, { x, y }: DrawnPoint): DrawnPoint {
  return { x: a * x + c * y + e, y: b * x + d * y + f };
}

function inverse([a, b, c, d, e, f]: Turn): Turn {
  const whole = a * d - b * c;
  return [d / whole, -b / whole, -c / whole, a / whole, (c * f - d * e) / whole, (b * e - a * f) / whole];
}

/** A path that remembers its lines, with the rules of a canvas. */
export class DrawnPath {
  readonly lines: DrawnPoint[][] = [];

  moveTo(x: number, y: number): void {
    this.lines.push([{ x, y }]);
  }

  lineTo(x: number, y: number): void {
    const line = this.lines.at(-1);
    if (line === undefined) {
      this.moveTo(x, y);
    } else if (line.at(-1)?.x !== x || line.at(-1)?.y !== y) {
      // One to where the pen is draws nothing.
      line.push({ x, y });
    }
  }

  /** The next line begins where this one has begun. */
  closePath(): void {
    const first = this.lines.at(-1)?.[0];
    if (first !== undefined) {
      this.lineTo(first.x, first.y);
    }
  }

  addPath(other: DrawnPath): void {
    this.lines.push(...other.lines);
  }
}

/** A 2D context that remembers what was drawn with it, and where on the picture that lies. */
export class DrawnContext {
  readonly drawn: Stroke[] = [];
  globalAlpha = 1;
  fillStyle = "";
  strokeStyle = "";
  lineWidth = 1;
  font = "";
  #turn: Turn = STRAIGHT;
  readonly #kept: { readonly turn: Turn; readonly fillStyle: string }[] = [];

  save(): void {
    this.#kept.push({ turn: this.#turn, fillStyle: this.fillStyle });
  }

  restore(): void {
    const kept = this.#kept.pop();
    if (kept === undefined) {
      throw new Error("restored more often than kept");
    }
    this.#turn = kept.turn;
    this.fillStyle = kept.fillStyle;
  }

  setTransform(a: number, b: number, c: number, d: number, e: number, f: number): void {
    this.#turn = [a, b, c, d, e, f];
  }

  resetTransform(): void {
    this.#turn = STRAIGHT;
  }

  getTransform() {
    const turn = this.#turn;
    return { inverse: () => ({ transformPoint: (point: DrawnPoint) => moved(inverse(turn), point) }) };
  }

  translate(x: number, y: number): void {
    this.#turn = times(this.#turn, [1, 0, 0, 1, x, y]);
  }

  rotate(angle: number): void {
    const [sine, cosine] = [Math.sin(angle), Math.cos(angle)];
    this.#turn = times(this.#turn, [cosine, sine, -sine, cosine, 0, 0]);
  }

  scale(x: number, y: number): void {
    this.#turn = times(this.#turn, [x, 0, 0, y, 0, 0]);
  }

  fillRect(x: number, y: number, width: number, height: number): void {
    const corners = [
      { x, y },
      { x: x + width, y },
      { x: x + width, y: y + height },
      { x, y: y + height },
    ];
    this.#add("rectangle", [corners], this.fillStyle);
  }

  fill(path: DrawnPath, rule: string): void {
    this.#add("fill", path.lines, this.fillStyle, { path, rule });
  }

  stroke(path: DrawnPath): void {
    this.#add("stroke", path.lines, this.strokeStyle, { path });
  }

  fillText(text: string, x: number, y: number): void {
    this.#add("text", [[{ x, y }]], this.fillStyle, { text });
  }

  #add(
    kind: Stroke["kind"],
    lines: ReadonlyArray<readonly DrawnPoint[]>,
    colour: string,
    more: Partial<Stroke> = {},
  ): void {
    const turn = this.#turn;
    this.drawn.push({
      kind,
      lines: lines.map((line) => line.map((point) => moved(turn, point))),
      colour,
      alpha: this.globalAlpha,
      width_px: this.lineWidth * Math.hypot(turn[0], turn[1]),
      text: "",
      turn_deg: (Math.atan2(turn[1], turn[0]) * 180) / Math.PI,
      path: null,
      rule: "",
      ...more,
    });
  }
}
