import { useEffect } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useSentence } from "../../i18n/useSentence";
import type { SimulatedFaults } from "../../protocol/guards.gen";
import { useAsked } from "../../requests/useAsked";
import { useAdmission } from "../../requests/useRole";
import { useConnection, usePage, usePart } from "../../store/hooks";
import { Button } from "../../ui/Button";
import { Notice } from "../../ui/Notice";
import { EditScope } from "../../ui/openEdits";
import { Panel } from "../../ui/Panel";
import { EndAll } from "./FaultsNow";
import { FAULTS } from "./faultRequests";
import { faultSentence } from "./faultWords";
import { NewFault } from "./NewFault";
import { WindForm } from "./WindForm";

/** An instructor's panel: what goes wrong in the embedded simulator. For owners, while that simulator is in the loop. */
export function FaultPanel() {
  const isOwner = useAdmission(({ role }) => role === "owner");
  const flown = useConnection(({ phase, status }) =>
    phase === "open" ? (status?.simulator.faults ?? null) : null,
  );
  const isPast = usePage().past !== null;
  return isOwner && !isPast && flown !== null ? <Instructor flown={flown} /> : null;
}

function Instructor({ flown }: { readonly flown: SimulatedFaults }) {
  const { t } = useTranslation();
  const sentence = useSentence();
  const { store, read } = usePart(FAULTS);
  const { choices, failure } = useStore(store);
  useEffect(() => {
    void read();
  }, [read]);
  const none = flown.faults.length === 0 ? t("faults.noneNow") : undefined;
  return (
    <Panel title={t("faults.title")} className="faults" actions={<EndAll disabledReason={none} />}>
      <p className="faults-hint">{t("faults.hint")}</p>
      <Flown faults={flown.faults} />
      {failure !== null && <Notice level="error">{sentence(failure)}</Notice>}
      <EditScope>{choices !== null && <NewFault choices={choices} />}</EditScope>
      <EditScope>
        <WindForm wind={flown.wind} />
      </EditScope>
    </Panel>
  );
}

function Flown({ faults }: { readonly faults: SimulatedFaults["faults"] }) {
  const { t } = useTranslation();
  return (
    <ul className="faults-flown" aria-label={t("faults.flown")}>
      {faults.length === 0 && <li>{t("faults.noneNow")}</li>}
      {faults.map((fault) => (
        <FlownRow key={fault.id} fault={fault} />
      ))}
    </ul>
  );
}

function FlownRow({ fault }: { readonly fault: SimulatedFaults["faults"][number] }) {
  const { t } = useTranslation();
  const { end } = usePart(FAULTS);
  const { state, stateText } = useAsked(`faults.end.${fault.id}`);
  const now_s = useConnection(({ status }) => status?.server_time_s ?? 0);
  const name = faultSentence(t, fault);
  return (
    <li className="faults-row" data-on={fault.is_on}>
      <span>{name}</span>
      <span className="faults-time">
        {fault.is_on
          ? fault.ends_s === null
            ? t("faults.untilEnded")
            : t("faults.left", { seconds: whole(fault.ends_s - now_s) })
          : t("faults.beginsIn", { seconds: whole(fault.begins_s - now_s) })}
      </span>
      <Button
        onPress={() => void end(fault.id)}
        state={state}
        stateText={stateText}
        label={t("faults.endOne", { name })}
      >
        {t("faults.end")}
      </Button>
    </li>
  );
}

function whole(seconds: number): number {
  return Math.max(0, Math.ceil(seconds));
}
