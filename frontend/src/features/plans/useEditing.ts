import { type KeyboardEvent, type RefObject, useEffect, useRef } from "react";
import type { Position } from "../../lib/geodesy";
import { changed, inserted, moved, removed, type Waypoint, type WaypointField } from "../../lib/plan";
import { editPlan, MISSIONS, redoPlan, undoPlan } from "../../missions/planDrafts";
import { PLAN_LIMITS, type PlanName } from "../../protocol/missions";
import { usePart } from "../../store/hooks";

export interface PlanEdit {
  readonly box: RefObject<HTMLDivElement | null>;
  /** Put a waypoint to another place, as it was typed. */
  readonly place: (row: number, place: Position) => void;
  readonly change: (row: number, field: WaypointField, value: number) => void;
  /** Put the cursor into a cell, once it is rendered. */
  readonly go: (row: number, field: WaypointField) => void;
  readonly insert: () => void;
  readonly remove: () => void;
  readonly move: (by: -1 | 1) => void;
  readonly onKeyDown: (event: KeyboardEvent) => void;
}

/** The edits of a plan's rows, and the cursor's place after each. */
export function useEditing(
  plan: PlanName,
  selected: number | null,
  choose: (row: number | null) => void,
): PlanEdit {
  const { plans } = usePart(MISSIONS);
  const box = useRef<HTMLDivElement>(null);
  const wanted = useRef<{ readonly row: number; readonly field: WaypointField } | null>(null);
  useEffect(() => {
    if (wanted.current !== null) {
      const { row, field } = wanted.current;
      wanted.current = null;
      box.current?.querySelector<HTMLInputElement>(`[data-row="${row}"][data-field="${field}"]`)?.focus();
    }
  });

  const present = (): readonly Waypoint[] => plans.getState()[plan].draft.present;
  const put = (waypoints: readonly Waypoint[]): void => editPlan(plans, plan, waypoints);

  function go(row: number, field: WaypointField): void {
    wanted.current = { row, field };
    choose(row);
  }

  function insert(field: WaypointField = "latitude_deg"): void {
    const now = present();
    if (now.length < PLAN_LIMITS.count.maximum) {
      const behind = selected ?? now.length - 1;
      put(inserted(now, behind));
      go(behind + 1, field);
    }
  }

  function remove(field: WaypointField = "latitude_deg"): void {
    if (selected !== null) {
      put(removed(present(), selected));
      const left = present().length;
      if (left === 0) choose(null);
      else go(Math.min(selected, left - 1), field);
    }
  }

  function move(by: -1 | 1, field: WaypointField = "latitude_deg"): void {
    const now = present();
    if (selected !== null && now[selected + by] !== undefined) {
      put(moved(now, selected, by));
      go(selected + by, field);
    }
  }

  function onKeyDown(event: KeyboardEvent): void {
    const field = fieldOf(event.target);
    const keys: Readonly<Record<string, () => void>> = {
      "alt ArrowUp": () => move(-1, field),
      "alt ArrowDown": () => move(1, field),
      "alt Insert": () => insert(field),
      "alt Delete": () => remove(field),
      "ctrl z": () => undoPlan(plans, plan),
      "ctrl y": () => redoPlan(plans, plan),
      "ctrl shift z": () => redoPlan(plans, plan),
    };
    const act = keys[nameOf(event)];
    // While a cell is being edited, undo belongs to its text.
    if (act !== undefined && !(isTypedIn(event) && !event.altKey)) {
      event.preventDefault();
      act();
    }
  }

  return {
    box,
    go,
    insert: () => insert(),
    remove: () => remove(),
    move: (by) => move(by),
    place: (row, place) => {
      const waypoint = present()[row];
      if (waypoint !== undefined) put(present().with(row, { ...waypoint, ...place }));
    },
    change: (row, field, value) => put(changed(present(), row, field, value)),
    onKeyDown,
  };
}

function fieldOf(target: EventTarget): WaypointField {
  const field = target instanceof HTMLElement ? target.dataset["field"] : undefined;
  return field === "longitude_deg" || field === "altitude_ft" || field === "speed_kt"
    ? field
    : "latitude_deg";
}

function isTypedIn({ target }: KeyboardEvent): boolean {
  return target instanceof HTMLElement && target.dataset["edited"] === "true";
}

/** A key with its modifiers: "alt ArrowUp", "ctrl shift z". */
function nameOf({ altKey, ctrlKey, metaKey, shiftKey, key }: KeyboardEvent): string {
  const held = [altKey ? "alt" : "", ctrlKey || metaKey ? "ctrl" : "", shiftKey ? "shift" : ""];
  return [...held.filter((name) => name !== ""), key.length === 1 ? key.toLowerCase() : key].join(" ");
}
