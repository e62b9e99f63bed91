import { useCallback, useRef } from "react";
import { useTranslation } from "react-i18next";
import type { Aircraft } from "../../lib/aircraft";
import { formatAge } from "../../lib/format";
import { useAsked } from "../../requests/useAsked";
import { useConnection, useTelemetry } from "../../store/hooks";
import type { TelemetryStore } from "../../store/telemetry";
import { usePaint } from "../../store/usePaint";
import { StateMark } from "../../ui/StateMark";
import { SteadyText, type SteadyTextHandle } from "../../ui/SteadyText";
import { AUTOMATIC_FLAGS, automaticState, type ModeState } from "./modes";
import { useSource } from "./sourceReturn";
import "./modes.css";

interface Props {
  readonly aircraft: Aircraft;
  /** Show the control path with its switches. */
  readonly onPress: () => void;
}

/** Who flies and by what, as a pilot reads it over the attitude: from live values alone, with their age. */
export function ModeAnnunciator({ aircraft, onPress }: Props) {
  const { t } = useTranslation();
  const path = usePath();
  return (
    <button type="button" className="modes" onClick={onPress}>
      <span className="visually-hidden">{t("modes.open")}</span>
      <SourceMode />
      {aircraft === "hil" && <PathMode path={path} />}
      <AutomaticMode name="autopilot" aircraft={aircraft} path={path} />
      <AutomaticMode name="autotrim" aircraft={aircraft} path={path} />
      <SensorMode
        name="speed"
        field="airspeed_source"
        control="select_airspeed_source"
        words={[t("modes.gps"), t("modes.pitot")]}
      />
      <SensorMode
        name="altitude"
        field="altitude_source"
        control="select_altitude_source"
        words={[t("modes.gps"), t("modes.baro")]}
      />
      <Age />
    </button>
  );
}

type Path = "manual" | "assisted";

/** The path of the control signal; null while the source, and with it the path, is not known. */
function usePath(): Path | null {
  const source = useSource();
  const path = useConnection(({ status, phase }) => (phase === "open" ? (status?.hil.path ?? null) : null));
  return source === null ? null : path;
}

function SourceMode() {
  const { t } = useTranslation();
  const source = useSource();
  return (
    <Mode
      name="source"
      control="source"
      word={source === null ? null : t(`source.${source}`)}
      state={source === null ? "unknown" : "active"}
    />
  );
}

function PathMode({ path }: { readonly path: Path | null }) {
  const { t } = useTranslation();
  return (
    <Mode
      name="path"
      control="path"
      word={path === null ? null : t(path === "manual" ? "path.manual" : "modes.flyByWire")}
      state={path === null ? "unknown" : "active"}
    />
  );
}

function AutomaticMode(props: {
  readonly name: "autopilot" | "autotrim";
  readonly aircraft: Aircraft;
  readonly path: Path | null;
}) {
  const { t } = useTranslation();
  const { name, aircraft, path } = props;
  const isOn = useTelemetry((telemetry, now_ms) =>
    telemetry.liveFlag("heartbeat", AUTOMATIC_FLAGS[aircraft][name], now_ms),
  );
  const state = automaticState(isOn, aircraft, path);
  const word = { active: t("words.on"), armed: t("modes.armed"), off: t("words.off"), unknown: null }[state];
  return <Mode name={name} control={name} word={word} state={state} />;
}

function SensorMode(props: {
  readonly name: "speed" | "altitude";
  readonly field: "airspeed_source" | "altitude_source";
  readonly control: string;
  readonly words: readonly [string, string];
}) {
  const { name, field, control, words } = props;
  const source = useTelemetry((telemetry, now_ms) => telemetry.liveNumber("board_status", field, now_ms));
  const word = (source === null ? undefined : words[source]) ?? null;
  return <Mode name={name} control={control} word={word} state={word === null ? "unknown" : "active"} />;
}

/** One mode: its name, what it is now, and what became of the newest command about it. */
function Mode(props: {
  readonly name: "source" | "path" | "autopilot" | "autotrim" | "speed" | "altitude";
  readonly control: string;
  readonly word: string | null;
  readonly state: ModeState;
}) {
  const { t } = useTranslation();
  const { name, control, word, state } = props;
  const asked = useAsked(control);
  return (
    <span className="modes-cell" data-state={state} data-asked={asked.state}>
      <span className="modes-name">{t(`modes.${name}`)}</span>
      <span className="modes-word">{word ?? t("modes.unknown")}</span>
      <span className="visually-hidden">{`(${asked.stateText ?? t(`modes.state.${state}`)})`}</span>
      <StateMark state={asked.state} />
    </span>
  );
}

/** The age of the oldest message that the modes are read from. */
function Age() {
  const { t } = useTranslation();
  const text = useRef<SteadyTextHandle>(null);
  const state = useTelemetry((telemetry, now_ms) => telemetry.state("heartbeat", now_ms));
  const paint = useCallback(
    (telemetry: TelemetryStore, now_ms: number) => {
      const ages_s = (["heartbeat", "board_status"] as const)
        .map((topic) => telemetry.age_s(topic, now_ms))
        .filter((age_s) => age_s !== null);
      text.current?.write(ages_s.length === 0 ? t("words.dash") : formatAge(Math.max(...ages_s)));
    },
    [t],
  );
  usePaint("text", paint);
  return (
    <span className="modes-cell modes-age" data-state={state === "live" ? "off" : "unknown"}>
      <span className="modes-name">{t("modes.age")}</span>
      <SteadyText ref={text} chars={6} className="modes-word" />
    </span>
  );
}
