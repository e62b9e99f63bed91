export const EDGES = ["top", "bottom", "left", "right"] as const;
export type Edge = (typeof EDGES)[number];

/**
 * Where a toolbar is: docked at an edge of the window, or floating. A floating place is stored as shares (0..1) of
 * the free room, so that the toolbar stays inside the window at any size.
 */
export type Place = { readonly edge: Edge } | { readonly x: number; readonly y: number };

export interface Size {
  readonly width: number;
  readonly height: number;
}

export interface Point {
  readonly x: number;
  readonly y: number;
}

/** The place as stored text: the edge's name, or the two shares. */
export function placeText(place: Place): string {
  return "edge" in place ? place.edge : `${place.x.toFixed(4)} ${place.y.toFixed(4)}`;
}

/** The stored place; invalid values fall back to the top edge. */
export function readPlace(text: string | undefined): Place {
  const edge = EDGES.find((name) => name === text);
  if (edge !== undefined) {
    return { edge };
  }
  const shares = /^(?<x>[01]\.\d+) (?<y>[01]\.\d+)$/.exec(text ?? "")?.groups;
  return shares === undefined
    ? { edge: "top" }
    : { x: within(Number(shares["x"])), y: within(Number(shares["y"])) };
}

/** A toolbar dropped within this many pixels of an edge docks there. */
export const DOCK_PX = 48;

/** The edge where a toolbar dropped at this point docks; null for none. */
export function edgeAt(pointer: Point, window: Size): Edge | null {
  const distances: ReadonlyArray<readonly [Edge, number]> = [
    ["top", pointer.y],
    ["bottom", window.height - pointer.y],
    ["left", pointer.x],
    ["right", window.width - pointer.x],
  ];
  const [edge, distance_px] = distances.reduce((near, next) => (next[1] < near[1] ? next : near));
  return distance_px <= DOCK_PX ? edge : null;
}

/** The floating place of a toolbar whose left upper corner is at this point. */
export function floatingAt(corner: Point, bar: Size, window: Size): Place {
  return {
    x: share(corner.x, window.width - bar.width),
    y: share(corner.y, window.height - bar.height),
  };
}

/** How far an arrow key moves a floating toolbar, as a share of its room. */
const STEP = 0.02;

/**
 * The place after an arrow key: a docked toolbar goes to that edge, a floating one moves a step. Null for other keys.
 */
export function movedBy(key: string, place: Place): Place | null {
  const way = { ArrowUp: [0, -1], ArrowDown: [0, 1], ArrowLeft: [-1, 0], ArrowRight: [1, 0] }[key];
  if (way === undefined) {
    return null;
  }
  if ("edge" in place) {
    const edges: Readonly<Record<string, Edge>> = {
      ArrowUp: "top",
      ArrowDown: "bottom",
      ArrowLeft: "left",
      ArrowRight: "right",
    };
    const edge = edges[key];
    return edge === undefined || edge === place.edge ? null : { edge };
  }
  return { x: within(place.x + (way[0] ?? 0) * STEP), y: within(place.y + (way[1] ?? 0) * STEP) };
}

function share(offset_px: number, room_px: number): number {
  return room_px <= 0 ? 0 : within(offset_px / room_px);
}

function within(value: number): number {
  return Math.min(1, Math.max(0, value));
}
