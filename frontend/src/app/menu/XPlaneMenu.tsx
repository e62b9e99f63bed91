import { useTranslation } from "react-i18next";
import { isFlownByAutopilot } from "../../missions/planFacts";
import { useGatewayBlocked } from "../../requests/useBlocked";
import { useConnection, usePage, useTelemetry } from "../../store/hooks";
import { Menu, MenuAction, MenuRule } from "../../ui/MenuBar";
import { useChoosePath } from "../toolbars/useChoosePath";
import { useDialogs } from "../views/useDialogs";
import { CommandItem, useOutcome } from "./items";

/** The routes built into the board, by the board's number. */
const ROUTES = ["hil_load_gando", "hil_load_ruta_isla", "hil_load_alternativa", "hil_load_vuelo"] as const;

export function XPlaneMenu() {
  const { t } = useTranslation();
  return (
    <Menu label={t("menu.xplane")}>
      <Routes />
      <MenuRule />
      <CommandItem command="hil_fms_next_waypoint" />
      <CommandItem command="hil_fms_previous_waypoint" />
      <MenuRule />
      <PathItem path="manual" label={t("menu.pathManual")} />
      <PathItem path="assisted" label={t("menu.pathAssisted")} />
    </Menu>
  );
}

/** If the HIL autopilot flies, it asks first: the aircraft would turn to another route at once. */
function Routes() {
  const { t } = useTranslation();
  const { telemetry } = usePage();
  const { ask } = useDialogs();
  const loaded = useTelemetry((telemetry, now_ms) =>
    telemetry.liveNumber("board_status", "hil_plan_name", now_ms),
  );
  return ROUTES.map((command, route) => (
    <CommandItem
      key={command}
      command={command}
      isCurrent={loaded === route}
      confirm={(send) =>
        isFlownByAutopilot(telemetry, "hil")
          ? ask({
              title: t("plans.routeTitle"),
              text: t("plans.routeText"),
              confirm: t("plans.routeConfirm"),
              danger: true,
              onConfirm: send,
            })
          : send()
      }
    />
  ));
}

function PathItem({ path, label }: { path: "manual" | "assisted"; label: string }) {
  const choosePath = useChoosePath();
  const blocked = useGatewayBlocked();
  const current = useConnection(({ status, phase }) =>
    phase === "open" ? (status?.hil.path ?? null) : null,
  );
  return (
    <MenuAction
      label={label}
      isCurrent={current === path}
      disabledReason={path === "manual" ? undefined : blocked}
      onChoose={() => choosePath(path)}
      {...useOutcome("path", path)}
    />
  );
}
