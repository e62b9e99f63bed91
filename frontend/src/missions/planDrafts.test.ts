import { describe, expect, test } from "vitest";
import type { Waypoint } from "../lib/plan";
import type { BrowserStorage } from "../store/settings";
import {
  amendPlan,
  boardHas,
  createPlans,
  editPlan,
  forgetBoardPlan,
  planState,
  redoPlan,
  undoPlan,
} from "./planDrafts";

const first: Waypoint = { latitude_deg: 27.9, longitude_deg: -15.4, altitude_ft: 1000.1, speed_kt: 55 };
const second: Waypoint = { ...first, latitude_deg: 28 };

function storageWith(text: string | null): BrowserStorage & { kept: string | null } {
  return {
    kept: text,
    getItem() {
      return this.kept;
    },
    setItem(_, value) {
      this.kept = value;
    },
  };
}

test("a draft that was not sent outlasts the page", () => {
  const storage = storageWith(null);
  editPlan(createPlans(storage), "hil", [first, second]);
  const plans = createPlans(storage).getState();
  expect(plans.hil.draft.present).toEqual([first, second]);
  expect(plans.flight.draft.present).toEqual([]);
  expect(planState(plans.hil)).toBe("unknown");
});

test.each([
  ["nothing", null],
  ["rubbish", "{"],
  ["something else", '{"hil": [{"latitude_deg": "x"}], "flight": 3}'],
])("a browser that remembers %s begins with empty plans", (_, text) => {
  const plans = createPlans(storageWith(text)).getState();
  expect([plans.flight.draft.present, plans.hil.draft.present]).toEqual([[], []]);
});

test("a browser that forbids its storage does not keep the page from working", () => {
  const store = createPlans({
    getItem: () => {
      throw new Error("forbidden");
    },
    setItem: () => {
      throw new Error("forbidden");
    },
  });
  editPlan(store, "flight", [first]);
  expect(store.getState().flight.draft.present).toEqual([first]);
});

describe("a plan", () => {
  test("is empty, unknown, the same as the board's, or other than it", () => {
    const store = createPlans(null);
    const state = () => planState(store.getState().flight);
    expect(state()).toBe("empty");
    editPlan(store, "flight", [first]);
    expect(state()).toBe("unknown");
    boardHas(store, "flight", [{ ...first, altitude_ft: Math.fround(1000.1) }]);
    expect(state()).toBe("same");
    editPlan(store, "flight", [first, second]);
    expect(state()).toBe("differs");
    undoPlan(store, "flight");
    expect(state()).toBe("same");
    redoPlan(store, "flight");
    expect(state()).toBe("differs");
    forgetBoardPlan(store, "flight");
    expect(state()).toBe("unknown");
  });

  test("takes an edit further without a second step of its undo", () => {
    const store = createPlans(null);
    editPlan(store, "hil", [first]);
    editPlan(store, "hil", [second]);
    amendPlan(store, "hil", [{ ...second, altitude_ft: 1100 }]);
    amendPlan(store, "hil", [{ ...second, altitude_ft: 1200 }]);
    expect(store.getState().hil.draft.present[0]?.altitude_ft).toBe(1200);
    undoPlan(store, "hil");
    expect(store.getState().hil.draft.present).toEqual([first]);
  });

  test("leaves the other alone", () => {
    const store = createPlans(null);
    const before = store.getState().hil;
    editPlan(store, "flight", [first]);
    expect(store.getState().hil).toBe(before);
  });
});
