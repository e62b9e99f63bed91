/** Small dense linear systems as rows of numbers, for fits with a handful of unknowns. */

export type Row = readonly number[];
/** Three rows of three. */
export type Matrix3 = readonly [Row3, Row3, Row3];
type Row3 = readonly [number, number, number];

/** A pivot below this share of the largest is only rounding error. */
const RANK = 1e-10;

/**
 * Least squares of `rows` x = `values` by Householder reflections, whose accuracy depends on the condition of the
 * rows; normal equations would square it. Null if the rows do not determine all unknowns.
 */
export function leastSquares(rows: readonly Row[], values: readonly number[]): number[] | null {
  const width = rows[0]?.length ?? 0;
  const height = rows.length;
  if (width === 0 || height < width) {
    return null;
  }
  // By columns, with the values as the last one.
  const columns = Array.from({ length: width + 1 }, (_, column) =>
    Float64Array.from({ length: height }, (__, row) =>
      column < width ? (rows[row]?.[column] ?? 0) : (values[row] ?? 0),
    ),
  );
  const diagonal: number[] = [];
  for (let step = 0; step < width; step += 1) {
    diagonal.push(reflect(columns, step));
  }
  const largest = Math.max(...diagonal.map(Math.abs));
  if (!(largest > 0) || diagonal.some((pivot) => !(Math.abs(pivot) > RANK * largest))) {
    return null;
  }
  return backwards(columns, diagonal);
}

/** One reflection: makes the column zero below `step`. Returns the pivot; the reflection vector stays in the column. */
function reflect(columns: readonly Float64Array[], step: number): number {
  const column = columns[step] ?? new Float64Array();
  const length = Math.sqrt(product(column, column, step));
  const first = column[step] ?? 0;
  const pivot = first > 0 ? -length : length;
  if (pivot === 0 || !Number.isFinite(pivot)) {
    return 0;
  }
  column[step] = first - pivot;
  const scale = pivot * (first - pivot);
  for (let index = step + 1; index < columns.length; index += 1) {
    const other = columns[index] ?? column;
    const factor = product(column, other, step) / scale;
    for (let row = step; row < column.length; row += 1) {
      other[row] = (other[row] as number) + factor * (column[row] as number);
    }
  }
  return pivot;
}

/** Scalar product of two columns from a row on. */
function product(one: Float64Array, other: Float64Array, from: number): number {
  let sum = 0;
  for (let row = from; row < one.length; row += 1) {
    sum += (one[row] as number) * (other[row] as number);
  }
  return sum;
}

function backwards(columns: readonly Float64Array[], diagonal: readonly number[]): number[] {
  const width = diagonal.length;
  const right = columns[width] ?? new Float64Array();
  const found = new Array<number>(width).fill(0);
  for (let row = width - 1; row >= 0; row -= 1) {
    let rest = right[row] ?? 0;
    for (let column = row + 1; column < width; column += 1) {
      rest -= (columns[column]?.[row] ?? 0) * (found[column] ?? 0);
    }
    found[row] = rest / (diagonal[row] ?? 1);
  }
  return found;
}

/** Eigenvalues and, as rows, the eigenvectors of a symmetric matrix, by Jacobi's rotations. */
export function eigen3(matrix: Matrix3): { readonly values: Row3; readonly vectors: Matrix3 } {
  const a = matrix.map((row) => [...row]);
  const v = [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ];
  const at = (rows: number[][], row: number, column: number): number => rows[row]?.[column] ?? 0;
  for (let sweep = 0; sweep < 60; sweep += 1) {
    const pairs = [
      [0, 1],
      [0, 2],
      [1, 2],
    ] as const;
    const [p, q] = pairs.reduce((best, pair) =>
      Math.abs(at(a, pair[0], pair[1])) > Math.abs(at(a, best[0], best[1])) ? pair : best,
    );
    const off = at(a, p, q);
    if (Math.abs(off) <= 1e-15 * (Math.abs(at(a, p, p)) + Math.abs(at(a, q, q)))) {
      break;
    }
    const angle = 0.5 * Math.atan2(2 * off, at(a, q, q) - at(a, p, p));
    const [c, s] = [Math.cos(angle), Math.sin(angle)];
    for (let k = 0; k < 3; k += 1) {
      turn(a, k, p, k, q, c, s);
    }
    for (let k = 0; k < 3; k += 1) {
      turn(a, p, k, q, k, c, s);
      turn(v, p, k, q, k, c, s);
    }
  }
  const row = (rows: number[][], index: number): Row3 => [
    at(rows, index, 0),
    at(rows, index, 1),
    at(rows, index, 2),
  ];
  return { values: [at(a, 0, 0), at(a, 1, 1), at(a, 2, 2)], vectors: [row(v, 0), row(v, 1), row(v, 2)] };
}

function turn(
  rows: number[][],
  row1: number,
  column1: number,
  row2: number,
  column2: number,
  c: number,
  s: number,
): void {
  const [first, second] = [rows[row1]?.[column1] ?? 0, rows[row2]?.[column2] ?? 0];
  (rows[row1] ?? [])[column1] = c * first - s * second;
  (rows[row2] ?? [])[column2] = s * first + c * second;
}

/** The symmetric matrix with the same eigenvectors and `change` applied to its eigenvalues. */
export function spectral3(matrix: Matrix3, change: (value: number) => number): Matrix3 {
  const { values, vectors } = eigen3(matrix);
  const entry = (row: number, column: number): number =>
    vectors.reduce(
      (sum, vector, index) => sum + change(values[index] ?? 0) * (vector[row] ?? 0) * (vector[column] ?? 0),
      0,
    );
  const line = (row: number): Row3 => [entry(row, 0), entry(row, 1), entry(row, 2)];
  return [line(0), line(1), line(2)];
}

export function times3(matrix: Matrix3, [x, y, z]: Row3): Row3 {
  const line = (row: Row3): number => row[0] * x + row[1] * y + row[2] * z;
  return [line(matrix[0]), line(matrix[1]), line(matrix[2])];
}
