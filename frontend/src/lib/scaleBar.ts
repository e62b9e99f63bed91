/** The greatest of 1, 2, 5, 10, 20, 50... up to `most`, which is positive. */
export function roundLength(most: number): number {
  const power = 10 ** Math.floor(Math.log10(most));
  return power * ([5, 2].find((step) => step * power <= most) ?? 1);
}
