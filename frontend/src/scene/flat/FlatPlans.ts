import type { Aircraft, MapThing } from "../../lib/aircraft";
import type { Position } from "../../lib/geodesy";
import { carried } from "../../lib/planEdit";
import { nearest, type Point } from "../legs/geometry";
import { legAt } from "../legs/legHit";
import type { DrawnPlan } from "../legs/shape";
import { LEG_REACH_PX, type MapTarget, REACH_PX } from "../legs/target";
import type { PlanListener } from "../plan/PlanScene";
import type { Grip } from "../tools/MapPointer";
import { drawHome, drawPlan, type FlatAircraft, type MarkedPlace } from "./flatThings";
import { type FlatView, fromScreen, type ScreenPoint, toScreen } from "./projection";
import type { Words } from "./Words";

/** What comes last lies above. */
const ORDER: readonly Aircraft[] = ["hil", "flight"];

/** Both flight plans and home on the flat map, and what the pointer takes hold of there. */
export class FlatPlans {
  readonly #onChange: () => void;
  readonly #plans: Record<Aircraft, DrawnPlan | null> = { flight: null, hil: null };
  #home: MarkedPlace | null = null;
  #listener: PlanListener | null = null;
  #held: { readonly plan: Aircraft; readonly row: number; readonly to: Point } | null = null;

  constructor(onChange: () => void) {
    this.#onChange = onChange;
  }

  listen(listener: PlanListener | null): void {
    this.#listener = listener;
  }

  show(plan: Aircraft, drawn: DrawnPlan | null): void {
    this.#plans[plan] = drawn;
    this.#onChange();
  }

  showHome(home: MarkedPlace | null): void {
    this.#home = home;
    this.#onChange();
  }

  draw(context: CanvasRenderingContext2D, view: FlatView, words: Words): void {
    for (const plan of ORDER) {
      const drawn = this.#seen(plan);
      if (drawn !== null) {
        drawPlan(context, view, plan, drawn, words);
      }
    }
    if (this.#home !== null) {
      drawHome(context, view, this.#home, words);
    }
  }

  /** What can be taken hold of at this place of the view as it is now. */
  find(
    view: () => FlatView,
    at: ScreenPoint,
    aircraft: readonly FlatAircraft[],
    reach_px: number,
  ): Grip | null {
    const listener = this.#listener;
    const thing = listener === null ? null : this.#thingAt(view(), at, aircraft, reach_px);
    if (listener === null || thing === null) {
      return null;
    }
    const click = (isMore: boolean): void => listener.pick(thing, isMore);
    return thing.kind === "waypoint"
      ? { cursor: "grab", click, drag: (from) => this.#dragOf(listener, view, thing.plan, thing.row, from) }
      : { cursor: "pointer", click, drag: null };
  }

  /** Tell the listener about a gesture at this place of the view. */
  tell(
    gesture: "tap" | "double" | "menu",
    view: FlatView,
    at: ScreenPoint,
    aircraft: readonly FlatAircraft[],
    reach_px: number = REACH_PX.mouse,
  ): void {
    this.#listener?.[gesture](this.targetAt(view, at, aircraft, reach_px));
  }

  /** What lies at a place of the view. */
  targetAt(
    view: FlatView,
    at: ScreenPoint,
    aircraft: readonly FlatAircraft[],
    reach_px: number = REACH_PX.mouse,
  ): MapTarget {
    const legs = ORDER.toReversed().flatMap((plan) => {
      const drawn = this.#plans[plan];
      return drawn === null
        ? []
        : (legAt(plan, drawn, (point) => toScreen(view, point), at, LEG_REACH_PX) ?? []);
    });
    return {
      at,
      place: { ...fromScreen(view, at), height_m: null },
      thing: this.#thingAt(view, at, aircraft, reach_px),
      leg: legs[0] ?? null,
    };
  }

  #thingAt(
    view: FlatView,
    at: ScreenPoint,
    aircraft: readonly FlatAircraft[],
    reach_px: number,
  ): MapThing | null {
    const things = this.#things(aircraft);
    const spots = things.map(({ place }) => toScreen(view, place));
    const found = nearest(spots, at, reach_px);
    return found === null ? null : (things[found]?.thing ?? null);
  }

  /** While a waypoint is held, its plan is drawn with it where the pointer has it. */
  #seen(plan: Aircraft): DrawnPlan | null {
    const drawn = this.#plans[plan];
    const held = this.#held;
    return drawn === null || held === null || held.plan !== plan
      ? drawn
      : {
          ...drawn,
          waypoints: carried(drawn.waypoints, held.row, held.to, drawn.chosen),
          unsent: drawn.unsent.with(held.row, true),
        };
  }

  #things(
    aircraft: readonly FlatAircraft[],
  ): ReadonlyArray<{ readonly thing: MapThing; readonly place: Position }> {
    return [
      ...ORDER.flatMap((plan) =>
        (this.#plans[plan]?.waypoints ?? []).map((place, row) => ({
          thing: { kind: "waypoint", plan, row } as const,
          place,
        })),
      ),
      ...aircraft.map(({ plan, place }) => ({ thing: { kind: "aircraft", plan } as const, place })),
      ...(this.#home === null ? [] : [{ thing: { kind: "home" } as const, place: this.#home }]),
    ];
  }

  /** The map may move under the pointer meanwhile, after an aircraft. */
  #dragOf(listener: PlanListener, view: () => FlatView, plan: Aircraft, row: number, from: ScreenPoint) {
    const waypoint = this.#plans[plan]?.waypoints[row];
    if (waypoint === undefined) {
      return null;
    }
    const start = toScreen(view(), waypoint);
    // One of several selected ones takes the others along.
    if (this.#plans[plan]?.chosen.includes(row) !== true) {
      listener.pick({ kind: "waypoint", plan, row }, false);
    }
    const hold = (to: Point | null): void => {
      this.#held = to === null ? null : { plan, row, to };
      listener.drag(this.#held);
      this.#onChange();
    };
    return {
      move: (at: ScreenPoint): void => {
        const moved = { x: start.x + at.x - from.x, y: start.y + at.y - from.y };
        hold({ ...fromScreen(view(), moved), altitude_ft: waypoint.altitude_ft });
      },
      drop: (): void => {
        const to = this.#held?.to;
        hold(null);
        if (to !== undefined) {
          listener.drop(plan, row, to);
        }
      },
      cancel: (): void => hold(null),
    };
  }
}
