import { useMemo } from "react";
import { useTranslation } from "react-i18next";
import type { Position } from "../lib/geodesy";
import { inserted, type Push, removed, type Waypoint } from "../lib/plan";
import {
  appended,
  bestRow,
  insertedAt,
  insertedOnLeg,
  reversed,
  shifted,
  without,
  withSpeed,
} from "../lib/planEdit";
import { PLAN_LIMITS, type PlanName } from "../protocol/missions";
import { usePart } from "../store/hooks";
import { amendPlan, editPlan, MISSIONS } from "./planDrafts";
import { SELECTION, selectRows, selectThing } from "./selection";

/** Edits of one plan by the map and the tables; each is one step of its undo, and selects what it has made. */
export interface WaypointEdits {
  /** Why no waypoint can be changed; undefined if it can. */
  readonly fixed: string | undefined;
  /** Why none can be added. */
  readonly full: string | undefined;
  /** Why none can be taken away or turned round. */
  readonly empty: string | undefined;
  readonly append: (place: Position) => void;
  /** Where it makes the way longest by the least. */
  readonly insert: (place: Position) => void;
  readonly insertAt: (row: number, place: Position) => void;
  /** Behind this row: half way to the next, or straight ahead. */
  readonly insertHalfWay: (row: number) => void;
  readonly insertOnLeg: (row: number, share: number) => void;
  readonly remove: (rows: readonly number[]) => void;
  readonly reverse: () => void;
  /** `isRepeat`: a held key, which belongs to the step before. */
  readonly shift: (rows: readonly number[], by: Push, isRepeat: boolean) => void;
  readonly setSpeed: (rows: readonly number[], speed_kt: number) => void;
}

/** `waypoints`: what is shown and edited. */
export function useWaypointEdits(
  plan: PlanName,
  waypoints: readonly Waypoint[],
  isFixed: boolean,
): WaypointEdits {
  const { t } = useTranslation();
  const { plans } = usePart(MISSIONS);
  const selection = usePart(SELECTION);
  return useMemo(() => {
    const { maximum } = PLAN_LIMITS.count;
    const fixed = isFixed ? t("plans.fixed") : undefined;
    const full = fixed ?? (waypoints.length >= maximum ? t("plans.isFull", { maximum }) : undefined);
    const empty = fixed ?? (waypoints.length === 0 ? t("plans.nothingToExport") : undefined);
    const add = (row: number, after: readonly Waypoint[]): void => {
      if (full === undefined && after !== waypoints) {
        editPlan(plans, plan, after);
        selectThing(selection, { kind: "waypoint", plan, row });
      }
    };
    const insertAt = (row: number, place: Position): void => add(row, insertedAt(waypoints, row, place));
    return {
      fixed,
      full,
      empty,
      insertAt,
      append: (place) => add(waypoints.length, appended(waypoints, place)),
      insert: (place) => insertAt(bestRow(waypoints, place), place),
      insertHalfWay: (row) => add(row + 1, inserted(waypoints, row)),
      insertOnLeg: (row, share) => {
        // The leg back to the first of a plan that loops ends it.
        const at = row === 0 ? waypoints.length : row;
        const after = insertedOnLeg(waypoints, row, share);
        const made = after[row];
        if (row === 0 && made !== undefined) add(at, [...removed(after, 0), made]);
        else add(at, after);
      },
      remove: (rows) => {
        const after = without(waypoints, rows);
        if (empty === undefined && after !== waypoints) {
          editPlan(plans, plan, after);
          const next = Math.min(Math.min(...rows), after.length - 1);
          selectThing(selection, next < 0 ? null : { kind: "waypoint", plan, row: next });
        }
      },
      reverse: () => {
        if (empty === undefined) {
          editPlan(plans, plan, reversed(waypoints));
          const { thing, rows } = selection.getState();
          if (thing?.kind === "waypoint" && thing.plan === plan) {
            selectRows(
              selection,
              plan,
              rows.map((row) => waypoints.length - 1 - row).sort((one, other) => one - other),
            );
          }
        }
      },
      shift: (rows, by, isRepeat) => {
        const put = isRepeat ? amendPlan : editPlan;
        put(plans, plan, shifted(waypoints, rows, by));
      },
      setSpeed: (rows, speed_kt) => editPlan(plans, plan, withSpeed(waypoints, rows, speed_kt)),
    };
  }, [t, plans, selection, plan, waypoints, isFixed]);
}
