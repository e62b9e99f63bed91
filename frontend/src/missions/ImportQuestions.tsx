import { useState } from "react";
import { useTranslation } from "react-i18next";
import { METRES_PER_FOOT } from "../lib/units";
import { PLAN_LIMITS, type PlanName } from "../protocol/missions";
import { useUnit } from "../readouts/useUnit";
import { usePart, useTelemetry } from "../store/hooks";
import { Button } from "../ui/Button";
import { ConfirmDialog } from "../ui/ConfirmDialog";
import { Dialog } from "../ui/Dialog";
import { NumberField } from "../ui/NumberField";
import type { ImportAnswers, ImportQuestion } from "./importQuestion";
import { askAboutFile, MISSIONS, usePlans } from "./planDrafts";

/** Asks what a file does not say before it becomes the plan. Nothing is taken until it is answered. */
export function ImportQuestions({ plan }: { plan: PlanName }) {
  const missions = usePart(MISSIONS);
  const question = usePlans((plans) => plans[plan].question);
  if (question === null) {
    return null;
  }
  const close = (): void => askAboutFile(missions.plans, plan, null);
  const answer = (answers: ImportAnswers): void => {
    close();
    void missions.importPlan(plan, question.source, question.asker, { ...question.answers, ...answers });
  };
  if (question.kind === "first") {
    return (
      <FirstQuestion name={question.source.name} onAnswer={(first) => answer({ first })} onClose={close} />
    );
  }
  return question.kind === "track" ? (
    <TrackQuestion question={question} onAnswer={() => answer({ thin: true })} onClose={close} />
  ) : (
    <HomeQuestion question={question} onAnswer={(home_ft) => answer({ home_ft })} onClose={close} />
  );
}

interface FirstProps {
  name: string;
  onAnswer: (first: NonNullable<ImportAnswers["first"]>) => void;
  onClose: () => void;
}

function FirstQuestion({ name, onAnswer, onClose }: FirstProps) {
  const { t } = useTranslation();
  return (
    <ConfirmDialog
      title={t("plans.firstTitle")}
      text={t("plans.firstText", { file: name })}
      confirmLabel={t("plans.firstWaypoint")}
      other={{ label: t("plans.firstHome"), onPress: () => onAnswer("home") }}
      cancelLabel={t("dialog.cancel")}
      onConfirm={() => onAnswer("waypoint")}
      onCancel={onClose}
    />
  );
}

interface TrackProps {
  question: Extract<ImportQuestion, { kind: "track" }>;
  onAnswer: () => void;
  onClose: () => void;
}

function TrackQuestion({
  question: { source, points, waypoints, deviation_m },
  onAnswer,
  onClose,
}: TrackProps) {
  const { t } = useTranslation();
  const params = { file: source.name, points, waypoints, deviation: Math.ceil(deviation_m) };
  return (
    <ConfirmDialog
      title={t("plans.trackTitle")}
      text={t("plans.trackText", params)}
      confirmLabel={t("plans.trackTake", params)}
      cancelLabel={t("dialog.cancel")}
      onConfirm={onAnswer}
      onCancel={onClose}
    />
  );
}

interface HomeProps {
  question: Extract<ImportQuestion, { kind: "home" }>;
  onAnswer: (home_ft: number) => void;
  onClose: () => void;
}

function HomeQuestion({ question: { source, count, ground_ft }, onAnswer, onClose }: HomeProps) {
  const { t } = useTranslation();
  const altitude = useUnit("altitude");
  const [home_ft, setHome] = useState<number | null>(null);
  const gps_m = useTelemetry((telemetry, now_ms) => telemetry.liveNumber("gps", "altitude_m", now_ms));
  const { minimum, maximum } = PLAN_LIMITS.fields.altitude_ft;
  const proposals = [
    { key: "plans.homeGround", value_ft: ground_ft },
    { key: "plans.homeAircraft", value_ft: gps_m === null ? null : Math.round(gps_m / METRES_PER_FOOT) },
  ] as const;
  return (
    <Dialog
      title={t("plans.homeTitle")}
      description={t("plans.homeText", { file: source.name, count })}
      onClose={onClose}
      actions={
        <>
          <Button onPress={onClose}>{t("dialog.cancel")}</Button>
          <Button
            takesFields
            variant="primary"
            onPress={() => home_ft !== null && onAnswer(home_ft)}
            disabledReason={home_ft === null ? t("plans.homeFirst") : undefined}
          >
            {home_ft === null
              ? t("plans.homeTakeNone")
              : t("plans.homeTake", { altitude: altitude.format(home_ft), unit: altitude.label })}
          </Button>
        </>
      }
    >
      <NumberField
        label={t("plans.homeAltitude")}
        value={home_ft === null ? null : altitude.convert(home_ft)}
        minimum={altitude.convert(minimum)}
        maximum={altitude.convert(maximum)}
        step={10}
        format={(value) => value.toFixed(altitude.digits)}
        unit={altitude.label}
        onCommit={(shown) => setHome(altitude.revert(shown))}
      />
      <div className="plans-proposals">
        {proposals.map(({ key, value_ft }) =>
          value_ft === null ? null : (
            <Button key={key} onPress={() => setHome(value_ft)}>
              {t(key, { altitude: altitude.format(value_ft), unit: altitude.label })}
            </Button>
          ),
        )}
      </div>
      {ground_ft === null && <p>{t("plans.homeNoGround")}</p>}
    </Dialog>
  );
}
