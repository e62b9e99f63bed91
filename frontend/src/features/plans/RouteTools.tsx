import { useState } from "react";
import { useTranslation } from "react-i18next";
import { editPlan, MISSIONS, type RouteCommand, usePlans } from "../../missions/planDrafts";
import { isFlownByAutopilot } from "../../missions/planFacts";
import { ROUTES } from "../../protocol/messages.gen";
import { useAsked } from "../../requests/useAsked";
import { useBoardBlocked } from "../../requests/useBlocked";
import { usePage, usePart } from "../../store/hooks";
import { Button } from "../../ui/Button";
import { ConfirmDialog } from "../../ui/ConfirmDialog";
import { Select } from "../../ui/Select";

const COMMANDS = {
  gando: "hil_load_gando",
  ruta_isla: "hil_load_ruta_isla",
  alternativa: "hil_load_alternativa",
  vuelo: "hil_load_vuelo",
} as const satisfies Readonly<Record<string, RouteCommand>>;
type RouteName = keyof typeof COMMANDS;

interface Props {
  canTransfer: boolean;
  onReplace: (replace: () => void) => void;
}

/**
 * The four routes built into every board: load one into the board, or only into the table. If the HIL autopilot flies,
 * it asks first: the aircraft would turn to the route at once.
 */
export function RouteTools({ canTransfer, onReplace }: Props) {
  const { t } = useTranslation();
  const missions = usePart(MISSIONS);
  const { telemetry } = usePage();
  const [route, setRoute] = useState<RouteName | null>(null);
  const [isAsking, setAsking] = useState(false);
  const { state, stateText } = useAsked("plan.route");
  const blocked = useBoardBlocked();
  const fixed = usePlans((plans) => plans.hil.isFixed) ? t("plans.fixed") : undefined;
  const none = route === null ? t("plans.routeNone") : undefined;

  function begin(): void {
    setAsking(false);
    if (canTransfer) onReplace(load);
    else load();
  }

  function load(): void {
    if (route !== null) {
      void missions.loadRoute(COMMANDS[route], canTransfer, { control: "plan.route" });
    }
  }

  function take(): void {
    const found = ROUTES.find(({ name }) => name === route);
    if (found !== undefined) {
      editPlan(missions.plans, "hil", found.waypoints);
    }
  }

  return (
    <>
      <span className="plans-gap" />
      <Select
        label={t("plans.route")}
        hideLabel
        placeholder={t("plans.routeChoose")}
        value={route}
        onChange={setRoute}
        options={(Object.keys(COMMANDS) as RouteName[]).map((value) => ({
          value,
          label: ROUTES.find(({ name }) => name === value)?.title ?? value,
        }))}
      />
      <Button
        onPress={() => (isFlownByAutopilot(telemetry, "hil") ? setAsking(true) : begin())}
        state={state}
        stateText={stateText}
        disabledReason={blocked ?? none}
      >
        {t("plans.routeLoad")}
      </Button>
      <Button onPress={() => onReplace(take)} disabledReason={fixed ?? none}>
        {t("plans.routeTake")}
      </Button>
      {isAsking && (
        <ConfirmDialog
          title={t("plans.routeTitle")}
          text={t("plans.routeText")}
          confirmLabel={t("plans.routeConfirm")}
          cancelLabel={t("dialog.cancel")}
          danger
          onConfirm={begin}
          onCancel={() => setAsking(false)}
        />
      )}
    </>
  );
}
