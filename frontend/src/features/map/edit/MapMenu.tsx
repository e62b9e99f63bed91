import { useRef } from "react";
import { useTranslation } from "react-i18next";
import type { Aircraft } from "../../../lib/aircraft";
import { CAMERA_CHOICE } from "../../../lib/mapCamera";
import { METRES_PER_FOOT } from "../../../lib/units";
import { PLAN } from "../../../missions/planFacts";
import { SELECTION, selectRows } from "../../../missions/selection";
import { useNoTransfer } from "../../../missions/useNoTransfer";
import { useWaypointEdits, type WaypointEdits } from "../../../missions/useWaypointEdits";
import { ACTIONS } from "../../../requests/actions";
import { useBoardBlocked } from "../../../requests/useBlocked";
import type { GroundPlace } from "../../../scene/legs/target";
import { FIELD_WISH } from "../../../store/fieldWish";
import { usePage, usePart } from "../../../store/hooks";
import { choose } from "../../../store/settings";
import { AnchoredMenu, MenuAction, MenuRule } from "../../../ui/MenuBar";
import { useFlyHereBlocked } from "../plan/useFlyHere";
import { type MapPlan, useMapPlan } from "../plan/useMapPlan";
import { useOpenPlan } from "../plan/useOpenPlan";
import { useSelectedRows } from "../plan/useSelectedRows";
import { FOLLOW_CHOICE, useFlat } from "../scenes/useFlat";
import { useMapTools } from "../scenes/useScreenTools";
import { MAP_TOOL, measureFrom, type OpenMenu, useMapTool } from "../tools/mapTool";

/** The menu of a right click, of a long press, or of the menu key, at its spot of the map. */
export function MapMenu() {
  const menu = useMapTool((state) => state.menu);
  const tools = usePart(MAP_TOOL);
  const anchor = useRef<HTMLSpanElement>(null);
  const home = useRef<HTMLDivElement>(null);
  return (
    <div ref={home} className="map-menu">
      <span ref={anchor} className="map-menu-spot" style={{ left: menu?.x ?? 0, top: menu?.y ?? 0 }} />
      {menu !== null && (
        // A new spot is a new menu.
        <AnchoredMenu
          key={`${menu.x} ${menu.y}`}
          anchor={anchor}
          home={home}
          onClose={() => tools.setState({ menu: null })}
        >
          <Entries menu={menu} />
        </AnchoredMenu>
      )}
    </div>
  );
}

function Entries({ menu }: { menu: OpenMenu }) {
  const { t } = useTranslation();
  const tools = usePart(MAP_TOOL);
  const selection = usePart(SELECTION);
  const wishes = usePart(FIELD_WISH);
  const plans = { flight: useMapPlan("flight"), hil: useMapPlan("hil") };
  const open = useOpenPlan(plans.flight);
  const aircraft = menu.waypoint?.plan ?? menu.leg?.plan ?? open;
  const plan = plans[aircraft];
  const edits = useWaypointEdits(aircraft, plan.waypoints, plan.isFixed);
  const centre = useCentre();
  const waypoint = menu.waypoint === null ? undefined : plan.waypoints[menu.waypoint.row];
  const place: GroundPlace | null =
    waypoint === undefined ? menu.place : { ...waypoint, height_m: waypoint.altitude_ft * METRES_PER_FOOT };
  const sky = place === null ? t("map.edit.sky") : undefined;
  const all = plan.waypoints.map((_, index) => index);
  return (
    <>
      {menu.waypoint === null ? (
        <GroundEntries plan={plan} edits={edits} place={place} leg={menu.leg} />
      ) : (
        <WaypointEntries aircraft={aircraft} plan={plan} edits={edits} row={menu.waypoint.row} />
      )}
      <MenuAction label={t("map.edit.reverse")} onChoose={edits.reverse} disabledReason={edits.empty} />
      <MenuAction
        label={t("map.edit.selectAll")}
        onChoose={() => selectRows(selection, aircraft, all)}
        disabledReason={all.length === 0 ? t("map.plan.none") : undefined}
      />
      <MenuRule />
      <MenuAction
        label={t("map.edit.measureFrom")}
        onChoose={() => place !== null && measureFrom(tools, place)}
        disabledReason={sky}
      />
      <MenuAction
        label={t("map.edit.centre")}
        onChoose={() => place !== null && centre(place)}
        disabledReason={sky}
      />
      <MenuAction
        label={t("map.field.here")}
        onChoose={() => place !== null && wishes.setState({ wish: { centre: place } })}
        disabledReason={sky}
      />
    </>
  );
}

interface GroundProps {
  plan: MapPlan;
  edits: WaypointEdits;
  place: GroundPlace | null;
  leg: OpenMenu["leg"];
}

function GroundEntries({ plan, edits, place, leg }: GroundProps) {
  const { t } = useTranslation();
  const tools = usePart(MAP_TOOL);
  const flyHere = useFlyHereBlocked(plan);
  const sky = place === null ? t("map.edit.sky") : undefined;
  return (
    <>
      <MenuAction
        label={t("map.edit.flyHere")}
        onChoose={() => tools.setState({ flyTo: place })}
        disabledReason={flyHere ?? sky}
      />
      <MenuRule />
      <MenuAction
        label={t("map.edit.addHere")}
        onChoose={() => place !== null && edits.append(place)}
        disabledReason={edits.full ?? sky}
      />
      {leg === null ? (
        <MenuAction
          label={t("map.edit.insertHere")}
          onChoose={() => place !== null && edits.insert(place)}
          disabledReason={edits.full ?? edits.empty ?? sky}
        />
      ) : (
        <MenuAction
          label={t("map.edit.insertOnLeg", { number: leg.row + 1 })}
          onChoose={() => edits.insertOnLeg(leg.row, leg.share)}
          disabledReason={edits.full}
        />
      )}
    </>
  );
}

interface WaypointProps {
  aircraft: Aircraft;
  plan: MapPlan;
  edits: WaypointEdits;
  row: number;
}

function WaypointEntries({ aircraft, plan, edits, row }: WaypointProps) {
  const { t } = useTranslation();
  const rows = useSelectedRows(aircraft);
  const several = rows.length > 1 && rows.includes(row);
  return (
    <>
      <FlyTo aircraft={aircraft} plan={plan} row={row} />
      <MenuRule />
      <MenuAction
        label={
          several
            ? t("map.edit.removeSeveral", { count: rows.length })
            : t("map.edit.remove", { number: row + 1 })
        }
        onChoose={() => edits.remove(several ? rows : [row])}
        disabledReason={edits.fixed}
        aside={t("map.edit.keyDelete")}
      />
      <MenuAction
        label={t("map.edit.insertAfter", { number: row + 1 })}
        onChoose={() => edits.insertHalfWay(row)}
        disabledReason={edits.full}
      />
    </>
  );
}

/** The board's own command: possible where it has the plan that is shown. */
function FlyTo({ aircraft, plan, row }: { aircraft: Aircraft; plan: MapPlan; row: number }) {
  const { t } = useTranslation();
  const actions = usePart(ACTIONS);
  const blocked = useBoardBlocked();
  const unsupported = useNoTransfer().short;
  return (
    <MenuAction
      label={t("map.edit.flyTo", { number: row + 1 })}
      onChoose={() =>
        void actions.command(
          "go_to_waypoint",
          { control: `plan.goTo.${aircraft}` },
          { plan: PLAN[aircraft].number, index: row },
        )
      }
      disabledReason={blocked ?? unsupported ?? (plan.state === "same" ? undefined : t("plans.notOnBoard"))}
    />
  );
}

/** Put a place into the middle of the map that is shown, which follows nothing then. */
export function useCentre(): (place: GroundPlace) => void {
  const { settings } = usePage();
  const flat = useFlat();
  const globe = useMapTools();
  return (place) => {
    if (flat.isShown) {
      choose(settings, FOLLOW_CHOICE, "off");
      flat.scene?.centreOn(place);
    } else {
      choose(settings, CAMERA_CHOICE, "free");
      globe?.centreOn(place);
    }
  };
}
