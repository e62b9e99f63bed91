import { Upload } from "lucide-react";
import { type ReactNode, useState } from "react";
import { useTranslation } from "react-i18next";
import { sameRow, type Waypoint } from "../lib/plan";
import type { PlanIssue } from "../lib/planCheck";
import type { PlanName } from "../protocol/missions";
import { useAsked } from "../requests/useAsked";
import { usePart, useTelemetry } from "../store/hooks";
import { Button } from "../ui/Button";
import { ConfirmDialog } from "../ui/ConfirmDialog";
import { hazardsOf, MISSIONS, usePlans } from "./planDrafts";
import { PLAN } from "./planFacts";
import { useIssueText } from "./useIssueText";

interface Props {
  plan: PlanName;
  /** The board's plan, as far as it is known. */
  onBoard: readonly Waypoint[] | null;
  disabledReason: string | undefined;
  children: ReactNode;
}

/**
 * Sends the edited plan. The board starts a received plan at waypoint 1: if it flies a plan now, ask first whether it
 * should go on to its present waypoint. A plan that leaves the fence or meets the ground is asked about before.
 */
export function SendPlan({ plan, onBoard, disabledReason, children }: Props) {
  const { t } = useTranslation();
  const issueText = useIssueText();
  const missions = usePart(MISSIONS);
  const control = `plan.upload.${plan}`;
  const { state, stateText } = useAsked(control);
  const now = useFlown(plan, onBoard);
  const [asked, setAsked] = useState<FlightInProgress | null>(null);
  // What an open question offers stays under the finger when the stream ends; it follows the board while that is known.
  const flown = asked === null || (now.row !== null && asked.row !== null) ? now : asked;

  const hazards = usePlans((plans) => hazardsOf(plans[plan]));
  const [found, setFound] = useState<readonly PlanIssue[]>([]);

  function begin(): void {
    setFound([]);
    if (now.isFlown) setAsked(now);
    else send(null);
  }

  function send(goOnTo: number | null): void {
    setAsked(null);
    void missions.upload(plan, { control }, goOnTo);
  }

  const again = { label: t("plans.startAgain"), onPress: () => send(null) };
  const goOn =
    flown.row === null
      ? again
      : { label: t("plans.goOn", { number: flown.row + 1 }), onPress: () => send(flown.row) };
  return (
    <>
      <Button
        variant="primary"
        onPress={() => (hazards.length > 0 ? setFound(hazards) : begin())}
        state={state}
        stateText={stateText}
        disabledReason={disabledReason}
        icon={<Upload aria-hidden="true" size={14} />}
      >
        {children}
      </Button>
      {found.length > 0 && (
        <ConfirmDialog
          title={t("plans.hazardTitle")}
          text={found.map(issueText).join(" ")}
          confirmLabel={t("plans.hazardSend")}
          cancelLabel={t("dialog.cancel")}
          danger
          onConfirm={begin}
          onCancel={() => setFound([])}
        />
      )}
      {asked !== null && (
        <ConfirmDialog
          title={t("plans.sendTitle")}
          text={flown.to === null ? t("plans.sendUnknown") : t("plans.sendText", { number: flown.to + 1 })}
          confirmLabel={goOn.label}
          other={goOn === again ? undefined : again}
          cancelLabel={t("dialog.cancel")}
          danger={goOn === again}
          onConfirm={goOn.onPress}
          onCancel={() => setAsked(null)}
        />
      )}
    </>
  );
}

interface FlightInProgress {
  /** A start at waypoint 1 would change where the board flies to, or may do so. */
  readonly isFlown: boolean;
  /** Row of the board's plan that it flies to; null without live data. */
  readonly to: number | null;
  /** The same waypoint's row in the edited plan. */
  readonly row: number | null;
}

function useFlown(plan: PlanName, onBoard: readonly Waypoint[] | null): FlightInProgress {
  const { topic, autopilot } = PLAN[plan];
  const draft = usePlans((plans) => plans[plan].draft.present);
  const to = useTelemetry((telemetry, now_ms) => telemetry.liveNumber(topic, "waypoint", now_ms));
  // A live plan without a waypoint is no plan; without the stream an autopilot that is on may fly any.
  const mayFly = useTelemetry(
    (telemetry, now_ms) =>
      telemetry.state(topic, now_ms) !== "live" && telemetry.newestFlag("heartbeat", autopilot) === true,
  );
  const row = to === null ? null : sameRow(draft, onBoard, to);
  return { isFlown: to === null ? mayFly : to > 0 || row !== 0, to, row };
}
