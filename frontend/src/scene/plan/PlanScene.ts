import { Cartesian3 } from "@cesium/engine";
import type { Aircraft, MapThing } from "../../lib/aircraft";
import type { Position } from "../../lib/geodesy";
import { carried } from "../../lib/planEdit";
import { METRES_PER_FOOT } from "../../lib/units";
import type { Globe } from "../globe/Globe";
import { awayFromLine, nearest, type Point, type Spot } from "../legs/geometry";
import { legAt } from "../legs/legHit";
import type { DrawnPlan } from "../legs/shape";
import { LEG_REACH_PX, type MapTarget, REACH_PX } from "../legs/target";
import { type Grip, type MapPointer, pointerOf } from "../tools/MapPointer";
import { spotOnScreen } from "../tools/screen";
import { HomeMark } from "./HomeMark";
import { PlanLayer } from "./PlanLayer";
import { type DragWay, WaypointDrag } from "./WaypointDrag";

export interface PlanListener {
  /** Clicked; `isMore`: with a key that adds it to what is selected. */
  readonly pick: (thing: MapThing, isMore: boolean) => void;
  /** A waypoint is dragged to here; null: the drag ended or was cancelled. */
  readonly drag: (
    place: { readonly plan: Aircraft; readonly row: number; readonly to: Point } | null,
  ) => void;
  /** A waypoint was dropped here. */
  readonly drop: (plan: Aircraft, row: number, to: Point) => void;
  /** A short press where nothing can be picked. */
  readonly tap: (target: MapTarget) => void;
  readonly double: (target: MapTarget) => void;
  /** A right click or a long press. */
  readonly menu: (target: MapTarget) => void;
}

/** Where an aircraft is drawn, if it is. */
type AircraftPlace = (plan: Aircraft) => (Position & { readonly altitude_m: number }) | null;

const STEM_REACH_PX = 6;

/** Both flight plans, home, and the pointer's actions on them. */
export class PlanScene {
  readonly #globe: Globe;
  readonly #pointer: MapPointer;
  readonly #layers: Readonly<Record<Aircraft, PlanLayer>>;
  readonly #home: HomeMark;
  readonly #ends: readonly (() => void)[];
  readonly #plans: Record<Aircraft, DrawnPlan | null> = { flight: null, hil: null };
  #listener: PlanListener | null = null;
  #isAiming = false;
  #aircraft: AircraftPlace = () => null;
  #held: { readonly plan: Aircraft; readonly row: number; readonly to: Point } | null = null;

  constructor(globe: Globe) {
    this.#globe = globe;
    this.#pointer = pointerOf(globe);
    this.#layers = { flight: new PlanLayer(globe, "flight"), hil: new PlanLayer(globe, "hil") };
    this.#home = new HomeMark(globe);
    this.#ends = [
      this.#pointer.addFinder((at, reach_px) => this.#find(at, reach_px)),
      this.#pointer.onGesture({
        tap: (at) => this.#listener?.tap(this.targetAt(at)),
        double: (at) => this.#listener?.double(this.targetAt(at)),
        menu: (at, isFinger) =>
          this.#listener?.menu(this.targetAt(at, isFinger ? REACH_PX.touch : REACH_PX.mouse)),
      }),
      this.#pointer.onCursor(() => (this.#isAiming ? "crosshair" : "")),
    ];
  }

  /** The listener for clicks and drags; null: nothing can be clicked or dragged. */
  listen(listener: PlanListener | null, aircraft: AircraftPlace = () => null): void {
    this.#listener = listener;
    this.#aircraft = aircraft;
  }

  /** Whether a tap on the ground puts something there: the pointer shows it. */
  aim(isAiming: boolean): void {
    this.#isAiming = isAiming;
  }

  /** What lies at a spot of the canvas. */
  targetAt(at: Spot, reach_px: number = REACH_PX.mouse): MapTarget {
    const seen = (point: Point): Spot | null => spotOnScreen(this.#globe.scene, positionOf(point));
    const legs = (["flight", "hil"] as const).flatMap((plan) => {
      const drawn = this.#plans[plan];
      return (drawn === null ? null : legAt(plan, drawn, seen, at, LEG_REACH_PX)) ?? [];
    });
    return {
      at,
      place: this.#pointer.placeAt(at),
      thing: this.#thingAt(at, reach_px),
      leg: legs[0] ?? null,
    };
  }

  show(plan: Aircraft, drawn: DrawnPlan | null): void {
    this.#plans[plan] = drawn;
    this.#draw(plan);
  }

  showHome(home: (Position & { readonly label: string }) | null): void {
    this.#home.show(home);
  }

  dispose(): void {
    for (const end of this.#ends) {
      end();
    }
    this.#layers.flight.dispose();
    this.#layers.hil.dispose();
    this.#home.dispose();
  }

  /** While a waypoint is dragged, its plan is drawn with the waypoint at the pointer. */
  #draw(plan: Aircraft): void {
    const drawn = this.#plans[plan];
    const held = this.#held;
    this.#layers[plan].show(
      drawn === null || held === null || held.plan !== plan
        ? drawn
        : {
            ...drawn,
            waypoints: carried(drawn.waypoints, held.row, held.to, drawn.chosen),
            unsent: drawn.unsent.with(held.row, true),
          },
    );
  }

  #thingAt(at: Spot, reach_px: number): MapThing | null {
    const things = this.#things();
    const spots = things.map(({ position }) => spotOnScreen(this.#globe.scene, position));
    const found = nearest(spots, at, reach_px);
    return found === null ? null : (things[found]?.thing ?? null);
  }

  #find(at: Spot, reach_px: number): Grip | null {
    const listener = this.#listener;
    if (listener === null) {
      return null;
    }
    const thing = this.#thingAt(at, reach_px);
    if (thing !== null) {
      return thing.kind === "waypoint"
        ? this.#waypointGrip(listener, thing.plan, thing.row, "level")
        : { cursor: "pointer", click: (isMore) => listener.pick(thing, isMore), drag: null };
    }
    return this.#stemGrip(listener, at);
  }

  /**
   * Only the selected waypoint's stem can be grabbed: a plan's stems are dense and would catch drags that turn the
   * globe.
   */
  #stemGrip(listener: PlanListener, at: Spot): Grip | null {
    for (const plan of ["flight", "hil"] as const) {
      const row = this.#plans[plan]?.selected ?? null;
      const waypoint = row === null ? undefined : this.#plans[plan]?.waypoints[row];
      if (row !== null && waypoint !== undefined) {
        const top = spotOnScreen(this.#globe.scene, positionOf(waypoint));
        const foot = spotOnScreen(this.#globe.scene, positionOf({ ...waypoint, altitude_ft: 0 }));
        if (top !== null && foot !== null && awayFromLine(at, foot, top) <= STEM_REACH_PX) {
          return this.#waypointGrip(listener, plan, row, "upright");
        }
      }
    }
    return null;
  }

  #things(): ReadonlyArray<{ readonly thing: MapThing; readonly position: Cartesian3 }> {
    const plans = ["flight", "hil"] as const;
    const home = this.#home.position;
    return [
      ...plans.flatMap((plan) =>
        (this.#plans[plan]?.waypoints ?? []).map((waypoint, row) => ({
          thing: { kind: "waypoint", plan, row } as const,
          position: positionOf(waypoint),
        })),
      ),
      ...plans.flatMap((plan) => {
        const place = this.#aircraft(plan);
        return place === null
          ? []
          : [
              {
                thing: { kind: "aircraft", plan } as const,
                position: Cartesian3.fromDegrees(place.longitude_deg, place.latitude_deg, place.altitude_m),
              },
            ];
      }),
      ...(home === null ? [] : [{ thing: { kind: "home" } as const, position: home }]),
    ];
  }

  #waypointGrip(listener: PlanListener, plan: Aircraft, row: number, way: DragWay): Grip {
    return {
      cursor: way === "level" ? "grab" : "ns-resize",
      click: (isMore) => listener.pick({ kind: "waypoint", plan, row }, isMore),
      drag: (from, isShift) => {
        const waypoint = this.#plans[plan]?.waypoints[row];
        if (waypoint === undefined) {
          return null;
        }
        const wayOf = (isShifted: boolean): DragWay => (isShifted ? "upright" : way);
        const pulled = new WaypointDrag(this.#globe.scene, waypoint, from, wayOf(isShift));
        // One of several selected ones takes the others along.
        if (this.#plans[plan]?.chosen.includes(row) !== true) {
          listener.pick({ kind: "waypoint", plan, row }, false);
        }
        const hold = (to: Point | null): void => {
          this.#held = to === null ? null : { plan, row, to };
          listener.drag(this.#held);
          this.#draw(plan);
        };
        return {
          move: (at, isShifted) => hold(pulled.move(at, wayOf(isShifted))),
          drop: () => {
            const to = this.#held?.to;
            hold(null);
            if (to !== undefined) {
              listener.drop(plan, row, to);
            }
          },
          cancel: () => hold(null),
        };
      },
    };
  }
}

function positionOf({ longitude_deg, latitude_deg, altitude_ft }: Point): Cartesian3 {
  return Cartesian3.fromDegrees(longitude_deg, latitude_deg, altitude_ft * METRES_PER_FOOT);
}
