import { useCallback, useState } from "react";
import { useTranslation } from "react-i18next";
import { useSentence } from "../i18n/useSentence";
import { formatFixed, formatHeading, formatMinutes } from "../lib/format";
import type { PlanName } from "../protocol/missions";
import { useHeightText } from "../readouts/heightSets";
import { useUnit } from "../readouts/useUnit";
import { usePage, usePart } from "../store/hooks";
import { failureMessage } from "../store/messages";
import { MISSIONS } from "./planDrafts";
import { conditionsNow, type RehearsalEnd } from "./rehearsal";

/** Flies a plan's draft in the model, under the conditions of that moment. */
export function useRehearsal(plan: PlanName) {
  const missions = usePart(MISSIONS);
  const { telemetry, settings, pump } = usePage();
  const [isFlying, setFlying] = useState(false);
  const fly = useCallback(
    async (first: number): Promise<RehearsalEnd> => {
      const conditions = conditionsNow(telemetry, settings.getState(), plan, pump.now_ms);
      setFlying(true);
      const answer = await missions.rehearse(plan, first, conditions);
      setFlying(false);
      return { conditions, answer };
    },
    [missions, telemetry, settings, pump, plan],
  );
  return { isFlying, fly };
}

/** How a plan was flown, what was not judged, and the ground by which heights; or why it was not flown. */
export function useRehearsalText(): (end: RehearsalEnd) => string {
  const { t } = useTranslation();
  const sentence = useSentence();
  const speed = useUnit("speed");
  const heightText = useHeightText();
  return useCallback(
    ({ conditions, answer }) => {
      if (!answer.ok) {
        return sentence(failureMessage(answer.problem));
      }
      const { wind, windSource, start } = conditions;
      const { time_s, last, ground, fence, battery } = answer.value;
      const missing = [
        ...(ground === "whole" ? [] : [t(`rehearsalGround.${ground}`)]),
        ...(fence ? [] : [t("rehearsal.fence")]),
        ...(battery ? [] : [t("rehearsal.battery")]),
      ];
      const words = {
        time: formatMinutes(time_s),
        number: last + 1,
        start: t(start === null ? "rehearsal.fromWaypoint" : "rehearsal.fromHere"),
        wind: t(`rehearsalWind.${windSource}`, {
          from: formatHeading(wind.from_deg, 0) ?? t("words.dash"),
          speed: `${formatFixed(speed.convert(wind.speed_kt), 0)} ${speed.label}`,
        }),
      };
      return [
        t("rehearsal.flown", words),
        ...(missing.length === 0 ? [] : [t("rehearsal.missing", { what: missing.join(", ") })]),
        ...answer.value.heights.filter(({ datum }) => datum !== null).map(heightText),
      ].join(" ");
    },
    [t, sentence, speed, heightText],
  );
}
