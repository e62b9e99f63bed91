import type { Position } from "../../lib/geodesy";
import { captureRadius_m, type Waypoint } from "../../lib/plan";
import { turnAt } from "../../lib/turn";
import { METRES_PER_FOOT } from "../../lib/units";
import type { Place } from "../ribbon/vertices";
import { legPoints, type Point, ring } from "./geometry";

/** A plan to be drawn on the globe. */
export interface DrawnPlan {
  /** The draft. */
  readonly waypoints: readonly Waypoint[];
  /** The board's plan, if it is known and differs. */
  readonly board: readonly Waypoint[] | null;
  /** For each waypoint, whether the board lacks it as it is here. */
  readonly unsent: readonly boolean[];
  /** Index, in the board's plan, of the waypoint that is flown to; null if not live. */
  readonly active: number | null;
  /** Whether the first waypoint follows the last. */
  readonly loops: boolean;
  /** Bank of the turns that the line law flies; null: another law flies, or it is not known which. */
  readonly turnBank_deg: number | null;
  readonly selected: number | null;
  /** All selected rows, that one among them. */
  readonly chosen: readonly number[];
  /** The label beside a waypoint. */
  readonly label: (waypoint: Waypoint, row: number) => string;
}

export type LineKind =
  | "leg"
  | "unsentLeg"
  | "activeLeg"
  | "oldLeg"
  | "turn"
  | "ring"
  | "activeRing"
  | "stem"
  | "selectedStem";

export interface Line {
  readonly kind: LineKind;
  readonly places: readonly Place[];
}

export interface Dot {
  readonly at: Waypoint;
  readonly label: string;
  readonly isActive: boolean;
  readonly isSelected: boolean;
  readonly isUnsent: boolean;
}

/** Corners of a capture circle: a chord is at most half a metre in 200 inside the circle. */
const CORNERS = 48;

/**
 * Every line of a plan. While a plan is being edited, the board's is drawn too, and the active leg belongs to the
 * board's.
 */
export function linesOf(plan: DrawnPlan): readonly Line[] {
  const { waypoints, board, active, loops, turnBank_deg, unsent, selected, chosen } = plan;
  const flown = board === null ? active : null;
  const legs = drawnLegs(plan);
  const own = legs.map(({ from, to, row }) =>
    leg(row === flown ? "activeLeg" : unsent[row] || unsent[row - 1] ? "unsentLeg" : "leg", from, to),
  );
  const old = legsOf(board ?? [], loops).map(({ from, to, row }) =>
    leg(row === active ? "activeLeg" : "oldLeg", from, to),
  );
  const rings = waypoints.flatMap((waypoint, row) => {
    const kind = row === flown ? "activeRing" : "ring";
    return turnBank_deg === null
      ? [circle(waypoint, kind)]
      : captureOf(legs, waypoint, row, turnBank_deg, kind);
  });
  const target = board === null || active === null ? undefined : board[active];
  const stems = waypoints.map((waypoint, row) =>
    stem(waypoint, row === selected || chosen.includes(row) ? "selectedStem" : "stem"),
  );
  return [
    ...old,
    ...own,
    ...rings,
    ...(target === undefined ? [] : [circle(target, "activeRing")]),
    ...stems,
  ];
}

export function dotsOf({
  waypoints,
  board,
  active,
  selected,
  chosen,
  unsent,
  label,
}: DrawnPlan): readonly Dot[] {
  return waypoints.map((at, row) => ({
    at,
    label: label(at, row),
    isActive: board === null && row === active,
    isSelected: row === selected || chosen.includes(row),
    isUnsent: unsent[row] ?? false,
  }));
}

export interface LegEnds {
  readonly from: Waypoint;
  readonly to: Waypoint;
  /** Index of the waypoint at its end. */
  readonly row: number;
}

/** The legs of the draft as they are drawn. */
export function drawnLegs({ waypoints, board, loops }: DrawnPlan): readonly LegEnds[] {
  return legsOf(waypoints, loops && board === null);
}

function legsOf(waypoints: readonly Waypoint[], loops: boolean): readonly LegEnds[] {
  const before = (row: number): Waypoint | undefined =>
    row === 0 && loops && waypoints.length > 2
      ? waypoints.at(-1)
      : row === 0
        ? undefined
        : waypoints[row - 1];
  return waypoints.flatMap((to, row) => {
    const from = before(row);
    return from === undefined ? [] : [{ from, to, row }];
  });
}

function leg(kind: LineKind, from: Waypoint, to: Waypoint): Line {
  return { kind, places: legPoints(from, to).map(inSpace) };
}

function circle(waypoint: Waypoint, kind: "ring" | "activeRing"): Line {
  const around = ring(waypoint, captureRadius_m(waypoint.speed_kt), CORNERS);
  const { altitude_ft } = waypoint;
  return { kind, places: around.map((place) => inSpace({ ...place, altitude_ft })) };
}

/** The line at which the line law counts a waypoint as reached, and its turn there. */
function captureOf(
  legs: readonly LegEnds[],
  at: Waypoint,
  row: number,
  turnBank_deg: number,
  kind: "ring" | "activeRing",
): readonly Line[] {
  const before = legs.find((one) => one.row === row)?.from;
  const after = legs.find((one) => one.from === at)?.to ?? null;
  const turn = before === undefined ? null : turnAt(before, at, after, turnBank_deg);
  const level = (places: readonly Position[]): readonly Place[] =>
    places.map((place) => inSpace({ ...place, altitude_ft: at.altitude_ft }));
  return turn === null
    ? []
    : [
        ...(turn.arc.length === 0 ? [] : [{ kind: "turn", places: level(turn.arc) } as const]),
        { kind, places: level(turn.capture) },
      ];
}

/** Down to sea level: terrain hides what is below it. */
function stem(waypoint: Waypoint, kind: "stem" | "selectedStem"): Line {
  return { kind, places: [inSpace({ ...waypoint, altitude_ft: 0 }), inSpace(waypoint)] };
}

function inSpace({ longitude_deg, latitude_deg, altitude_ft }: Point): Place {
  return { longitude_deg, latitude_deg, altitude_m: altitude_ft * METRES_PER_FOOT };
}
