import { describe, expect, test, vi } from "vitest";
import type { Waypoint } from "../../lib/plan";
import type { DrawnPlan } from "../legs/shape";
import { FlatPlans } from "./FlatPlans";
import type { FlatAircraft } from "./flatThings";
import { type FlatView, fromScreen, panned, toScreen } from "./projection";

const waypoints: readonly Waypoint[] = [
  { latitude_deg: 27.95, longitude_deg: -15.37, altitude_ft: 700, speed_kt: 55 },
  { latitude_deg: 27.92, longitude_deg: -15.36, altitude_ft: 1000, speed_kt: 60 },
];
const VIEW: FlatView = {
  centre: { latitude_deg: 27.93, longitude_deg: -15.38 },
  zoom: 13,
  width_px: 800,
  height_px: 600,
};
const HOME = { latitude_deg: 27.9, longitude_deg: -15.39, label: "Casa" };
const AIRCRAFT: FlatAircraft = {
  plan: "hil",
  place: { latitude_deg: 27.93, longitude_deg: -15.4 },
  heading_deg: 90,
  colour: "#fff",
  label: "HIL",
  isLive: true,
};

function drawn(): DrawnPlan {
  return {
    waypoints,
    board: null,
    unsent: waypoints.map(() => false),
    active: null,
    loops: false,
    turnBank_deg: null,
    selected: null,
    chosen: [],
    label: (_, row) => String(row + 1),
  };
}

function plans() {
  const listener = {
    pick: vi.fn(),
    drag: vi.fn(),
    drop: vi.fn(),
    tap: vi.fn(),
    double: vi.fn(),
    menu: vi.fn(),
  };
  const all = new FlatPlans(() => undefined);
  all.show("flight", drawn());
  all.showHome(HOME);
  all.listen(listener);
  return { all, listener };
}

describe("a press on the flat map", () => {
  test("chooses the waypoint, aircraft or home that is near it, and nothing else", () => {
    const { all, listener } = plans();
    for (const place of [waypoints[1], AIRCRAFT.place, HOME]) {
      const { x, y } = toScreen(VIEW, place ?? HOME);
      all.find(() => VIEW, { x: x + 6, y: y - 6 }, [AIRCRAFT], 14)?.click(false);
    }
    expect(listener.pick.mock.calls).toEqual([
      [{ kind: "waypoint", plan: "flight", row: 1 }, false],
      [{ kind: "aircraft", plan: "hil" }, false],
      [{ kind: "home" }, false],
    ]);
    expect(all.find(() => VIEW, { x: 5, y: 5 }, [AIRCRAFT], 14)).toBeNull();
  });

  test("takes hold of nothing while nobody listens", () => {
    const { all } = plans();
    all.listen(null);
    expect(all.find(() => VIEW, toScreen(VIEW, HOME), [], 14)).toBeNull();
  });
});

describe("a waypoint that is pulled", () => {
  function pulled(view: () => FlatView) {
    const { all, listener } = plans();
    const from = toScreen(VIEW, waypoints[0] ?? HOME);
    const held = { x: from.x + 3, y: from.y + 2 };
    const drag = all.find(view, held, [], 14)?.drag?.(held, false);
    return { listener, drag, held };
  }

  test("goes with the pointer at its altitude, and is put down where it was let go", () => {
    const { listener, drag, held } = pulled(() => VIEW);
    drag?.move({ x: held.x + 40, y: held.y - 25 }, false);
    drag?.drop();
    const [plan, row, to] = listener.drop.mock.calls[0] ?? [];
    expect([plan, row, to.altitude_ft]).toEqual(["flight", 0, 700]);
    const start = toScreen(VIEW, waypoints[0] ?? HOME);
    const there = fromScreen(VIEW, { x: start.x + 40, y: start.y - 25 });
    expect(to.latitude_deg).toBeCloseTo(there.latitude_deg, 9);
    expect(to.longitude_deg).toBeCloseTo(there.longitude_deg, 9);
    expect(listener.drag).toHaveBeenLastCalledWith(null);
  });

  test("stays under the pointer when the map moves meanwhile", () => {
    let view = VIEW;
    const { listener, drag, held } = pulled(() => view);
    view = panned(VIEW, 60, 0);
    drag?.move(held, false);
    const { to } = listener.drag.mock.lastCall?.[0] ?? {};
    expect(toScreen(view, to).x).toBeCloseTo(held.x - 3, 6);
  });

  test("goes back where it was when the pull is given up", () => {
    const { listener, drag, held } = pulled(() => VIEW);
    drag?.move({ x: held.x + 40, y: held.y }, false);
    drag?.cancel();
    expect(listener.drop).not.toHaveBeenCalled();
    expect(listener.drag).toHaveBeenLastCalledWith(null);
  });
});

describe("a place of the flat map", () => {
  test("on a leg says which leg and how far along, away from it none", () => {
    const { all, listener } = plans();
    const [one, two] = [toScreen(VIEW, waypoints[0] ?? HOME), toScreen(VIEW, waypoints[1] ?? HOME)];
    const at = { x: one.x + 0.25 * (two.x - one.x), y: one.y + 0.25 * (two.y - one.y) };
    all.tell("double", VIEW, at, []);
    const [target] = listener.double.mock.calls[0] ?? [];
    expect(target.leg).toMatchObject({ plan: "flight", row: 1 });
    expect(target.leg.share).toBeCloseTo(0.25, 2);
    all.tell("tap", VIEW, { x: 5, y: 5 }, []);
    expect(listener.tap.mock.calls[0]?.[0]).toMatchObject({ leg: null, thing: null });
  });

  test("that is pulled with others selected takes them along", () => {
    const { all, listener } = plans();
    all.show("flight", { ...drawn(), selected: 0, chosen: [0, 1] });
    const from = toScreen(VIEW, waypoints[0] ?? HOME);
    const drag = all.find(() => VIEW, from, [], 14)?.drag?.(from, false);
    expect(listener.pick).not.toHaveBeenCalled();
    drag?.move({ x: from.x + 30, y: from.y }, false);
    drag?.drop();
    expect(listener.drop).toHaveBeenCalledOnce();
  });
});
