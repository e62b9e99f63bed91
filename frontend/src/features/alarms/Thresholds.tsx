import { RotateCcw } from "lucide-react";
import { useEffect } from "react";
import { useTranslation } from "react-i18next";
import { useSentence } from "../../i18n/useSentence";
import { useAsked } from "../../requests/useAsked";
import { useGatewayBlocked } from "../../requests/useBlocked";
import { useConnection, usePart } from "../../store/hooks";
import { Button } from "../../ui/Button";
import { Notice } from "../../ui/Notice";
import { NumberField } from "../../ui/NumberField";
import { Panel } from "../../ui/Panel";
import type { Threshold } from "./alarmLog";
import { ALARM_LOG } from "./alarmLog";
import { useAlarmLogState } from "./useAlarms";

/** The thresholds of the alarms. They belong to the station and hold for every page. */
export function Thresholds() {
  const { t } = useTranslation();
  const alarmLog = usePart(ALARM_LOG);
  const thresholds = useAlarmLogState((state) => state.thresholds);
  const isOpen = useConnection(({ phase }) => phase === "open");
  useEffect(() => {
    if (isOpen) {
      void alarmLog.readThresholds();
    }
  }, [alarmLog, isOpen]);
  return (
    <Panel title={t("alarmLog.thresholds")}>
      {thresholds === null ? (
        <p className="alarms-none">{t("alarmLog.notRead")}</p>
      ) : (
        <>
          <Battery />
          <ul className="alarms-thresholds">
            {thresholds.map((threshold) => (
              <Field key={threshold.name} threshold={threshold} />
            ))}
          </ul>
        </>
      )}
    </Panel>
  );
}

/** What the battery's alarm goes by. While its cells are only guessed, a press says how many there are. */
function Battery() {
  const { t } = useTranslation();
  const alarmLog = usePart(ALARM_LOG);
  const blocked = useGatewayBlocked();
  const battery = useAlarmLogState((state) => state.battery);
  const { state, stateText } = useAsked("threshold.battery_cells");
  if (battery === null) {
    return null;
  }
  const { cells, highest_v, low_v, is_guessed } = battery;
  if (!is_guessed) {
    return <Notice level="info">{t("alarmLog.battery", { cells, highest_v, low_v })}</Notice>;
  }
  return (
    <Notice level="warning">
      {t("alarmLog.batteryAsked", { cells, highest_v, low_v })}
      <div className="alarms-battery">
        {[cells, cells + 1].map((number) => (
          <Button
            key={number}
            onPress={() =>
              void alarmLog.setThreshold("battery_cells", number, { control: "threshold.battery_cells" })
            }
            state={state}
            stateText={stateText}
            disabledReason={blocked}
          >
            {t("alarmLog.batteryYes", { cells: number })}
          </Button>
        ))}
      </div>
    </Notice>
  );
}

/** Step of 0.1 for small ranges, else 1; of 1 for what is counted. */
function stepOf({ maximum, unit, default: usual }: Threshold): number {
  return unit === "" || (maximum >= 100 && (usual >= 10 || usual === 0)) ? 1 : 0.1;
}

function Field({ threshold }: { threshold: Threshold }) {
  const { t } = useTranslation();
  const alarmLog = usePart(ALARM_LOG);
  const sentence = useSentence();
  const blocked = useGatewayBlocked();
  const { name, value, default: usual, minimum, maximum, unit } = threshold;
  const control = `threshold.${name}`;
  const { state, stateText } = useAsked(control);
  const label = sentence({ level: "info", key: `alarmThreshold.${name}`, params: {}, fallback: name });
  return (
    <li className="alarms-threshold">
      <NumberField
        label={label}
        value={value}
        onCommit={(next) => void alarmLog.setThreshold(name, next, { control })}
        minimum={minimum}
        maximum={maximum}
        step={stepOf(threshold)}
        unit={unit}
        state={state}
        stateText={stateText}
        disabledReason={blocked}
      />
      <Button
        onPress={() => void alarmLog.setThreshold(name, usual, { control })}
        disabledReason={blocked ?? (value === usual ? t("alarmLog.isDefault") : undefined)}
        icon={<RotateCcw size={14} aria-hidden="true" />}
        label={t("alarmLog.resetOne", { label })}
      >
        {null}
      </Button>
      <span className="alarms-range">
        <span>{t("alarmLog.range", { minimum, maximum, unit })}</span>
        <span>{t("alarmLog.default", { value: usual, unit })}</span>
      </span>
    </li>
  );
}
