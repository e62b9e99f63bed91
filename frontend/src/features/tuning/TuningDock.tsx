import { Maximize2, Minimize2, X } from "lucide-react";
import { Fragment, type ReactNode, useEffect, useMemo, useRef, useState } from "react";
import { useTranslation } from "react-i18next";
import { AIRCRAFT, type Aircraft } from "../../lib/aircraft";
import { PARAMETERS, type ParameterName } from "../../protocol/messages.gen";
import {
  LEAST_SPAN,
  LOOPS,
  type LoopName,
  loopParameters,
  loopSignals,
  TURNING,
} from "../../protocol/tuning";
import { LivePlot, type PlotEvent } from "../../readouts/LivePlot";
import type { Signal } from "../../readouts/signals";
import { usePage, useSettings } from "../../store/hooks";
import { choose } from "../../store/settings";
import { Button } from "../../ui/Button";
import { SegmentedSwitch } from "../../ui/SegmentedSwitch";
import { Select } from "../../ui/Select";
import { rollDemand } from "./rollDemand";
import "./tuning.css";

interface Props {
  readonly field: (name: ParameterName) => ReactNode;
  /** The gains that the board has; null: unknown. */
  readonly values: Readonly<Record<ParameterName, number | null>>;
}

/** The loop whose tuning view is open, or null. */
export function useTuningLoop(): LoopName | null {
  return useSettings(({ choices }) => LOOPS.find((loop) => loop === choices["tuning.loop"]) ?? null);
}

/**
 * The gains of one control loop beside a live plot of its signals. It is docked under every tab, so that the
 * aircraft's answer can be watched while a gain is changed; its plot keeps its past when the tab changes.
 */
export function TuningDock({ field, values }: Props) {
  const { t } = useTranslation();
  const { settings } = usePage();
  const loop = useTuningLoop();
  const aircraft = useSettings(
    ({ choices }) => AIRCRAFT.find((one) => one === choices["tuning.aircraft"]) ?? "hil",
  );
  const isLarge = useSettings(({ choices }) => choices["tuning.size"] === "large");
  const signals = useSignals(loop, aircraft, values.k_heading);
  const changes = useChanges(values);
  if (loop === null) {
    return null;
  }
  return (
    <section className="tuning" aria-label={t("tuning.title")} data-size={isLarge ? "large" : "small"}>
      <header className="tuning-head">
        <h2 className="ui-panel-title">{t("tuning.title")}</h2>
        <Select
          label={t("tuning.loop")}
          hideLabel
          placeholder={t("tuning.choose")}
          value={loop}
          onChange={(next) => choose(settings, "tuning.loop", next)}
          options={LOOPS.map((value) => ({ value, label: t(`tuningLoop.${value}`) }))}
        />
        <SegmentedSwitch
          label={t("tuning.aircraft")}
          hideLabel
          value={aircraft}
          onChange={(next) => choose(settings, "tuning.aircraft", next)}
          options={[
            { value: "hil", label: t("tuning.hil") },
            { value: "flight", label: t("tuning.flight") },
          ]}
        />
        <span className="tuning-gap" />
        <Button
          onPress={() => choose(settings, "tuning.size", isLarge ? "small" : "large")}
          label={t(isLarge ? "tuning.smaller" : "tuning.larger")}
          icon={
            isLarge ? <Minimize2 aria-hidden="true" size={14} /> : <Maximize2 aria-hidden="true" size={14} />
          }
        >
          {null}
        </Button>
        <Button
          onPress={() => choose(settings, "tuning.loop", "")}
          label={t("tuning.close")}
          icon={<X aria-hidden="true" size={14} />}
        >
          {null}
        </Button>
      </header>
      <div className="tuning-body">
        <div className="tuning-fields">
          {loopParameters(loop).map((name) => (
            <Fragment key={name}>{field(name)}</Fragment>
          ))}
        </div>
        <LivePlot
          signals={signals}
          label={t("tuning.plot", { loop: t(`tuningLoop.${loop}`) })}
          events={changes}
          fromRecording
        />
      </div>
    </section>
  );
}

function useSignals(loop: LoopName | null, aircraft: Aircraft, k_heading: number | null): readonly Signal[] {
  const { t } = useTranslation();
  // Read with each value, so that another gain is no other signal: its line goes on.
  const gain = useRef(k_heading);
  useEffect(() => {
    gain.current = k_heading;
  }, [k_heading]);
  return useMemo(() => {
    const moved = (loop === null ? [] : loopSignals(loop, aircraft)).map(
      ([name, { unit, ...signal }]): Signal => ({
        ...signal,
        label: t(`signal.${name}`),
        least_span: LEAST_SPAN[unit ?? "none"],
        ...(TURNING.has(name) ? { turn: 360 } : {}),
        ...(unit === null ? {} : { unit: t(`unit.${unit}`) }),
      }),
    );
    if (loop !== "roll" && loop !== "heading") {
      return moved;
    }
    const text = { label: t("signal.rollAsked"), least_span: LEAST_SPAN.deg, unit: t("unit.deg") };
    return [rollDemand(aircraft, () => gain.current, text), ...moved];
  }, [t, loop, aircraft]);
}

/** As many changes as a plot of half a minute can show. */
const KEPT = 20;

interface Changes {
  readonly given: Props["values"];
  /** The last value known of each: a change made while the gateway was away is a change. */
  readonly known: Props["values"];
  readonly events: readonly PlotEvent[];
  readonly count: number;
}

/** Each change of a gain on the board since the view was opened. A gain that becomes known has not changed. */
function useChanges(values: Props["values"]): readonly PlotEvent[] {
  const [seen, setSeen] = useState<Changes>({ given: values, known: values, events: [], count: 0 });
  if (seen.given === values) {
    return seen.events;
  }
  const next = changed(seen, values);
  setSeen(next);
  return next.events;
}

function changed({ known, events, count }: Changes, values: Props["values"]): Changes {
  const moved = PARAMETERS.flatMap(({ name }) => {
    const [before, after] = [known[name], values[name]];
    return before === null || after === null || before === after ? [] : [`${name} ${before} → ${after}`];
  });
  const fresh = moved.map((label, index): PlotEvent => ({ key: `${count + index}`, label }));
  const names = PARAMETERS.map(({ name }) => name);
  return {
    given: values,
    known: Object.fromEntries(names.map((name) => [name, values[name] ?? known[name]])) as Props["values"],
    // A mark is kept as long as it may be in the picture.
    events: fresh.length === 0 ? events : [...events, ...fresh].slice(-KEPT),
    count: count + fresh.length,
  };
}
