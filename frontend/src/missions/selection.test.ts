import { expect, test } from "vitest";
import type { MapThing } from "../lib/aircraft";
import { createSelection, selectRows, selectThing, toggleThing } from "./selection";

function waypoint(row: number, plan: "flight" | "hil" = "hil"): MapThing {
  return { kind: "waypoint", plan, row };
}

test("at first nothing is selected", () => {
  expect(createSelection().getState()).toEqual({ thing: null, rows: [] });
});

test("a waypoint that is selected alone is the only row, and home leaves no row", () => {
  const store = createSelection();
  selectRows(store, "hil", [1, 2, 3]);
  selectThing(store, waypoint(4));
  expect(store.getState()).toEqual({ thing: waypoint(4), rows: [4] });
  selectThing(store, { kind: "home" });
  expect(store.getState()).toEqual({ thing: { kind: "home" }, rows: [] });
  selectThing(store, null);
  expect(store.getState()).toEqual({ thing: null, rows: [] });
});

test("waypoints that are added are kept in the plan's order, and the last one added leads", () => {
  const store = createSelection();
  selectThing(store, waypoint(10));
  toggleThing(store, waypoint(2));
  toggleThing(store, waypoint(4));
  expect(store.getState()).toEqual({ thing: waypoint(4), rows: [2, 4, 10] });
});

test("the highest that is left leads when the leading waypoint is taken away", () => {
  const store = createSelection();
  selectRows(store, "hil", [2, 4, 10]);
  toggleThing(store, waypoint(2));
  expect(store.getState()).toEqual({ thing: waypoint(10), rows: [4, 10] });
});

test("nothing is selected when the last waypoint is taken away", () => {
  const store = createSelection();
  selectThing(store, waypoint(3));
  toggleThing(store, waypoint(3));
  expect(store.getState()).toEqual({ thing: null, rows: [] });
});

test("waypoints of two plans are never selected together", () => {
  const store = createSelection();
  selectRows(store, "hil", [0, 1]);
  toggleThing(store, waypoint(5, "flight"));
  expect(store.getState()).toEqual({ thing: waypoint(5, "flight"), rows: [5] });
});

test("an aircraft is selected alone, and the waypoint after it too", () => {
  const store = createSelection();
  selectRows(store, "hil", [0, 1]);
  toggleThing(store, { kind: "aircraft", plan: "hil" });
  expect(store.getState()).toEqual({ thing: { kind: "aircraft", plan: "hil" }, rows: [] });
  toggleThing(store, waypoint(1));
  expect(store.getState()).toEqual({ thing: waypoint(1), rows: [1] });
});

test("the first of many rows leads, and no rows are nothing", () => {
  const store = createSelection();
  selectRows(store, "flight", [3, 7]);
  expect(store.getState()).toEqual({ thing: waypoint(3, "flight"), rows: [3, 7] });
  selectRows(store, "flight", []);
  expect(store.getState()).toEqual({ thing: null, rows: [] });
});
