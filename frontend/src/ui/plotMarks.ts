/** A moment to be marked by a line. */
export interface PlotMark {
  /** Relative to now, zero or less. */
  readonly before_s: number;
  readonly label: string;
}

export interface MarkLook {
  readonly text: string;
  /** The plot's ground, under a label. */
  readonly ground: string;
  readonly font: string;
  /** Pixels of the canvas in one of the page. */
  readonly ratio: number;
}

/** What is needed of a uPlot: its canvas, the rectangle of its lines, and where a value lies. Pixels of the canvas. */
export interface MarkedPlot {
  readonly ctx: CanvasRenderingContext2D;
  readonly bbox: {
    readonly left: number;
    readonly top: number;
    readonly width: number;
    readonly height: number;
  };
  readonly valToPos: (value: number, scale: string, canvasPixels: boolean) => number;
}

const GAP_PX = 4;
const LINE_HEIGHT = 1.2;

/**
 * A line from top to bottom for each mark, its label beside its top, in the first row in which it lies on no other.
 * A label has a ground of its own: the line of the mark beside it does not go through its letters.
 */
export function drawMarks(plot: MarkedPlot, marks: readonly PlotMark[], look: MarkLook): void {
  const { ctx, bbox } = plot;
  const right = bbox.left + bbox.width;
  const gap = GAP_PX * look.ratio;
  const line = LINE_HEIGHT * (Number.parseFloat(look.font) || 12) * look.ratio;
  ctx.save();
  ctx.beginPath();
  ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
  ctx.clip();
  ctx.font = look.font.replace(/^([\d.]+)px/, (_, px) => `${Number(px) * look.ratio}px`);
  ctx.strokeStyle = look.text;
  ctx.setLineDash([gap, gap]);
  ctx.textAlign = "left";
  const labels = marks.map(({ before_s, label }) => {
    const x = Math.round(plot.valToPos(before_s, "x", true));
    ctx.beginPath();
    ctx.moveTo(x, bbox.top);
    ctx.lineTo(x, bbox.top + bbox.height);
    ctx.stroke();
    const width = ctx.measureText(label).width;
    // At the right end there is no room beside the line.
    const from = x + 2 * gap + width > right ? x - gap - width : x + gap;
    return { label, from, to: from + width };
  });
  for (const [index, row] of rowsOf(labels, gap).entries()) {
    const { label = "", from = 0, to = 0 } = labels[index] ?? {};
    ctx.fillStyle = look.ground;
    ctx.fillRect(from - gap / 2, bbox.top + line * (row + 0.1), to - from + gap, line);
    ctx.fillStyle = look.text;
    ctx.fillText(label, from, bbox.top + line * (row + 1));
  }
  ctx.restore();
}

/** The first row of each label in which it lies beside all that were there before it. */
function rowsOf(
  labels: ReadonlyArray<{ readonly from: number; readonly to: number }>,
  gap: number,
): number[] {
  const rows: number[] = [];
  for (const [index, { from, to }] of labels.entries()) {
    const taken = new Set(
      labels
        .slice(0, index)
        .flatMap((other, place) => (from < other.to + gap && other.from < to + gap ? [rows[place]] : [])),
    );
    let row = 0;
    while (taken.has(row)) {
      row += 1;
    }
    rows.push(row);
  }
  return rows;
}
