import { type RefObject, useEffect, useRef } from "react";
import type { Push } from "../../../lib/plan";
import { MISSIONS, redoPlan, undoPlan } from "../../../missions/planDrafts";
import { SELECTION, selectRows, selectThing } from "../../../missions/selection";
import { useWaypointEdits } from "../../../missions/useWaypointEdits";
import type { MapTarget } from "../../../scene/legs/target";
import { usePart } from "../../../store/hooks";
import { useMapPlan } from "../plan/useMapPlan";
import { useOpenPlan } from "../plan/useOpenPlan";
import { menuAt } from "../plan/usePlanHands";
import { useSelectedRows } from "../plan/useSelectedRows";
import { useStep } from "../plan/useStep";
import { useFlat } from "../scenes/useFlat";
import { usePlanLayer } from "../scenes/useScreenTools";
import { chooseTool, MAP_TOOL } from "../tools/mapTool";

const PUSHES: Readonly<Record<string, (step: number) => Push>> = {
  "alt ArrowUp": (north_m) => ({ north_m }),
  "alt ArrowDown": (step) => ({ north_m: -step }),
  "alt ArrowRight": (east_m) => ({ east_m }),
  "alt ArrowLeft": (step) => ({ east_m: -step }),
  "alt PageUp": (up_ft) => ({ up_ft }),
  "alt PageDown": (step) => ({ up_ft: -step }),
};

/** The keys of the plan that is edited, while the map has the focus; and the cross that they aim with. */
export function MapKeys({ picture }: { picture: RefObject<HTMLElement | null> }) {
  const tools = usePart(MAP_TOOL);
  const selection = usePart(SELECTION);
  const { plans } = usePart(MISSIONS);
  const flat = useFlat();
  const globe = usePlanLayer();
  const flight = useMapPlan("flight");
  const hil = useMapPlan("hil");
  const open = useOpenPlan(flight);
  const plan = open === "flight" ? flight : hil;
  const edits = useWaypointEdits(open, plan.waypoints, plan.isFixed);
  const rows = useSelectedRows(open);
  const step = useStep();

  /** What lies in the middle of the picture, where the cross is. */
  function middle(): MapTarget | null {
    const { clientWidth = 0, clientHeight = 0 } = picture.current ?? {};
    const at = { x: clientWidth / 2, y: clientHeight / 2 };
    return (flat.isShown ? flat.scene?.targetAt(at) : globe?.targetAt(at)) ?? null;
  }

  function add(): void {
    const target = middle();
    if (target?.leg?.plan === open) edits.insertOnLeg(target.leg.row, target.leg.share);
    else if (target !== null && target.place !== null) edits.append(target.place);
  }

  function menu(): void {
    const target = middle();
    const row = rows[0];
    if (target !== null) {
      // The menu of what is selected; without it, of the middle.
      tools.setState({
        menu: {
          ...menuAt(target),
          waypoint: row === undefined ? menuAt(target).waypoint : { plan: open, row },
        },
      });
    }
  }

  function selectNext(by: 1 | -1): void {
    const count = plan.waypoints.length;
    const from = rows[0] ?? (by === 1 ? -1 : count);
    if (count > 0) {
      selectThing(selection, { kind: "waypoint", plan: open, row: (from + by + count) % count });
    }
  }

  const keys: Readonly<Record<string, () => void>> = {
    Insert: add,
    Delete: () => edits.remove(rows),
    n: () => selectNext(1),
    p: () => selectNext(-1),
    "ctrl a": () =>
      selectRows(
        selection,
        open,
        plan.waypoints.map((_, row) => row),
      ),
    "ctrl z": () => plan.isFixed || undoPlan(plans, open),
    "ctrl y": () => plan.isFixed || redoPlan(plans, open),
    "ctrl shift z": () => plan.isFixed || redoPlan(plans, open),
    ContextMenu: menu,
    "shift F10": menu,
  };

  function press(event: KeyboardEvent): void {
    const name = nameOf(event);
    const push = PUSHES[name];
    const act = keys[name];
    if (event.key === "Escape" && tools.getState().tool === "add") chooseTool(tools, "pick");
    else if (push !== undefined && rows.length > 0 && !plan.isFixed)
      edits.shift(rows, push(step), event.repeat);
    else if (act !== undefined) act();
    else return;
    event.preventDefault();
    event.stopPropagation();
  }

  const newest = useRef(press);
  useEffect(() => {
    newest.current = press;
  });
  useEffect(() => {
    const element = picture.current;
    const listen = (event: KeyboardEvent): void => {
      // Only the map itself: the fields and buttons over it have keys of their own.
      if (event.target instanceof HTMLElement && event.target.closest("[role=application]") !== null) {
        newest.current(event);
      }
    };
    element?.addEventListener("keydown", listen);
    return () => element?.removeEventListener("keydown", listen);
  }, [picture]);
  return <span className="map-cross" aria-hidden="true" />;
}

/** A key with its modifiers: "alt ArrowUp", "ctrl shift z". */
function nameOf({ altKey, ctrlKey, metaKey, shiftKey, key }: KeyboardEvent): string {
  const held = [altKey ? "alt" : "", ctrlKey || metaKey ? "ctrl" : "", shiftKey ? "shift" : ""];
  return [...held.filter((name) => name !== ""), key.length === 1 ? key.toLowerCase() : key].join(" ");
}
