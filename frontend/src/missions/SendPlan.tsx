import { Upload } from "lucide-react";
import { type ReactNode, useEffect, useRef, useState } from "react";
import { useTranslation } from "react-i18next";
import { sameRow, type Waypoint } from "../lib/plan";
import type { PlanFault } from "../lib/planCheck";
import type { PlanName } from "../protocol/missions";
import { useHeightText } from "../readouts/heightSets";
import { useAsked } from "../requests/useAsked";
import { usePage, usePart, useTelemetry } from "../store/hooks";
import { Button } from "../ui/Button";
import { ConfirmDialog } from "../ui/ConfirmDialog";
import { hazardsOf, MISSIONS, usePlans } from "./planDrafts";
import { PLAN } from "./planFacts";
import { doubtfulHeights, type FlownIssue, flownIssues, type RehearsalEnd } from "./rehearsal";
import { useIssueText } from "./useIssueText";
import { useRehearsal, useRehearsalText } from "./useRehearsal";

interface Props {
  plan: PlanName;
  /** The board's plan, as far as it is known. */
  onBoard: readonly Waypoint[] | null;
  disabledReason: string | undefined;
  children: ReactNode;
}

/**
 * Sends the edited plan. The board starts a received plan at waypoint 1: if it flies a plan now, ask first whether it
 * should go on to its present waypoint. Then the plan is flown in the model; where that found something, or was not
 * done, or the plan has hazards by its geometry, ask before it is sent.
 */
export function SendPlan({ plan, onBoard, disabledReason, children }: Props) {
  const { t } = useTranslation();
  const missions = usePart(MISSIONS);
  const { messages } = usePage();
  const issueText = useIssueText();
  const rehearsalText = useRehearsalText();
  const heightText = useHeightText();
  const { isFlying, fly } = useRehearsal(plan);
  const control = `plan.upload.${plan}`;
  const { state, stateText } = useAsked(control);
  const now = useFlown(plan, onBoard);
  const [asked, setAsked] = useState<FlightInProgress | null>(null);
  // An open question follows the board while that is known, and keeps what it offers when the stream ends.
  const flown = asked === null || now.row !== null ? now : asked;
  const [found, setFound] = useState<Found | null>(null);
  const isShown = useRef(true);
  useEffect(() => {
    isShown.current = true;
    return () => {
      isShown.current = false;
    };
  }, []);

  async function rehearse(goOnTo: number | null): Promise<void> {
    setAsked(null);
    messages.say({ level: "info", key: "rehearsal.flying", params: {} });
    const draft = (): readonly Waypoint[] => missions.plans.getState()[plan].draft.present;
    let of = draft();
    let end = await fly(goOnTo ?? 0);
    while (of !== draft()) {
      // Edited meanwhile: what is sent is what was flown.
      of = draft();
      end = await fly(goOnTo ?? 0);
    }
    const sentences = sentencesOf(end);
    if (end.answer.ok && sentences.length === 0) {
      messages.say({ level: "info", key: "rehearsal.saidClean", params: { what: rehearsalText(end) } });
      send(goOnTo);
    } else if (isShown.current) {
      setFound({ end, sentences, goOnTo });
    } else {
      // Nobody is there to be asked.
      messages.say({ level: "warning", key: "rehearsal.saidNotSent", params: { what: `@planName.${plan}` } });
    }
  }

  function sentencesOf(end: RehearsalEnd): readonly string[] {
    const issues = flownIssues(end);
    const hazards = hazardsOf(missions.plans.getState()[plan]).filter(
      ({ code, row }) => !issues.some((issue) => issue.row === row && issue.code === FLOWN[code]),
    );
    return [...[...hazards, ...issues].map(issueText), ...doubtfulHeights(end).map(heightText)];
  }

  function send(goOnTo: number | null): void {
    setFound(null);
    void missions.upload(plan, { control }, goOnTo);
  }

  const again = { label: t("plans.startAgain"), onPress: () => void rehearse(null) };
  const goOn =
    flown.row === null
      ? undefined
      : { label: t("plans.goOn", { number: flown.row + 1 }), onPress: () => void rehearse(flown.row) };
  // The answer under the finger stays the one that it was when it was asked.
  const [usual, other] = goOn === undefined || asked?.row === null ? [again, goOn] : [goOn, again];
  return (
    <>
      <Button
        variant="primary"
        onPress={() => (now.isFlown ? setAsked(now) : void rehearse(null))}
        state={isFlying ? "pending" : state}
        stateText={isFlying ? t("rehearsal.flying") : stateText}
        disabledReason={isFlying ? t("rehearsal.flying") : disabledReason}
        takesFields
        icon={<Upload aria-hidden="true" size={14} />}
      >
        {children}
      </Button>
      {found !== null && (
        <ConfirmDialog
          title={t(found.end.answer.ok ? "plans.hazardTitle" : "rehearsal.notFlownTitle")}
          text={rehearsalText(found.end)}
          list={found.sentences}
          confirmLabel={t("plans.hazardSend")}
          cancelLabel={t("dialog.cancel")}
          danger
          onConfirm={() => send(found.goOnTo)}
          onCancel={() => setFound(null)}
        />
      )}
      {asked !== null && (
        <ConfirmDialog
          title={t("plans.sendTitle")}
          text={flown.to === null ? t("plans.sendUnknown") : t("plans.sendText", { number: flown.to + 1 })}
          confirmLabel={usual.label}
          other={other}
          cancelLabel={t("dialog.cancel")}
          danger={usual === again}
          onConfirm={usual.onPress}
          onCancel={() => setAsked(null)}
        />
      )}
    </>
  );
}

/** What a person is asked about before the plan is sent. */
interface Found {
  readonly end: RehearsalEnd;
  readonly sentences: readonly string[];
  readonly goOnTo: number | null;
}

/** The finding of a flight that says the same as a hazard of the geometry, and more. */
const FLOWN: Partial<Record<PlanFault, FlownIssue["code"]>> = {
  outside_fence: "flown_leaves_fence",
  leaves_fence: "flown_leaves_fence",
  above_ceiling: "flown_above_ceiling",
  meets_ground: "flown_meets_ground",
};

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
