/** Half the side of a round instrument's picture, in its units. */
export const HALF_SIDE = 100;

/**
 * CSS transform of a layer: turned clockwise about the picture's middle, then shifted along its own turned axes (x
 * right, y down) in units of the picture. The housing is a container whose smaller side is the picture's, so `cqmin`
 * measures the picture.
 */
export function layerTransform(
  turn_deg: number,
  { x = 0, y = 0, halfSide = HALF_SIDE }: { x?: number; y?: number; halfSide?: number } = {},
): string {
  const shift = (units: number): string => `${Math.round((units * 50_000) / halfSide) / 1000}cqmin`;
  const turned = turn_deg === 0 ? "" : `rotate(${turn_deg}deg)`;
  return x === 0 && y === 0 ? turned || "none" : `${turned} translate(${shift(x)}, ${shift(y)})`.trim();
}

/** Written only when it changes. */
export function setTransform(element: HTMLElement | null, transform: string): void {
  if (element !== null && element.style.transform !== transform) {
    element.style.transform = transform;
  }
}
