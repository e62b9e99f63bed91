import { useTranslation } from "react-i18next";
import { formatBytes } from "../../lib/format";
import type { FlightDisk } from "../../protocol/guards.gen";
import { useAsked } from "../../requests/useAsked";
import { usePart } from "../../store/hooks";
import { Checkbox } from "../../ui/Checkbox";
import { NumberField } from "../../ui/NumberField";
import { Panel } from "../../ui/Panel";
import { FLIGHTS } from "./flightLibrary";
import { useLibraryBlocked } from "./useFlights";

const GIGABYTE = 1_000_000_000;
/** Less than this is shown as a warning. */
const FEW_HOURS = 2;

/** Room for more flights, and what happens when it ends. */
export function DiskPanel({
  disk: { free_bytes, used_bytes, hours_left, policy },
}: {
  readonly disk: FlightDisk;
}) {
  const { t } = useTranslation();
  const { setPolicy } = usePart(FLIGHTS);
  const control = "flights.policy";
  const { state, stateText } = useAsked(control);
  const blocked = useLibraryBlocked("owner");
  const keep_gb = policy.keep_free_bytes / GIGABYTE;
  return (
    <Panel title={t("flights.disk")} className="flights-disk">
      <p>
        {free_bytes === null
          ? t("flights.freeUnknown")
          : t("flights.free", { bytes: formatBytes(free_bytes) })}{" "}
        {t("flights.used", { bytes: formatBytes(used_bytes) })}{" "}
        <span data-caution={hours_left !== null && hours_left < FEW_HOURS} className="flights-hours">
          {hours_left === null
            ? t("flights.hoursUnknown")
            : t("flights.hours", { hours: hoursText(hours_left) })}
        </span>
      </p>
      <Checkbox
        label={t("flights.deleteOldest")}
        checked={policy.delete_oldest}
        disabledReason={blocked}
        onChange={(delete_oldest) => void setPolicy({ ...policy, delete_oldest }, { control })}
      />
      <NumberField
        label={t("flights.keepFree")}
        unit={t("flights.gigabytes")}
        value={keep_gb}
        minimum={1}
        maximum={10_000}
        step={1}
        state={state}
        stateText={stateText}
        disabledReason={blocked}
        onCommit={(gigabytes) =>
          void setPolicy({ ...policy, keep_free_bytes: Math.round(gigabytes * GIGABYTE) }, { control })
        }
      />
      <p className="flights-explained">
        {policy.delete_oldest
          ? t("flights.policyDeletes", { bytes: formatBytes(policy.keep_free_bytes) })
          : t("flights.policyKeeps")}
      </p>
    </Panel>
  );
}

function hoursText(hours: number): string {
  return hours < 10 ? hours.toFixed(1) : Math.round(hours).toString();
}
