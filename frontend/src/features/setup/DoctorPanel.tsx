import { CircleCheck, Info, RefreshCw, TriangleAlert } from "lucide-react";
import { useEffect } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useSentence } from "../../i18n/useSentence";
import type { DoctorFinding } from "../../protocol/guards.gen";
import { useAdmission } from "../../requests/useRole";
import { useConnection, usePage, usePart, useSettings } from "../../store/hooks";
import { Button } from "../../ui/Button";
import { Notice } from "../../ui/Notice";
import { Panel } from "../../ui/Panel";
import "./doctor.css";
import { DOCTOR } from "./doctor";

const ICONS = { ok: CircleCheck, note: Info, fault: TriangleAlert } as const;

/** What `epf-gcs doctor` finds on the station's computer. It tells of that computer, so it is for owners. */
export function DoctorPanel() {
  const isOwner = useAdmission(({ role }) => role === "owner");
  const isOpen = useConnection(({ phase }) => phase === "open");
  const isPast = usePage().past !== null;
  return isOwner && isOpen && !isPast ? <Findings /> : null;
}

function Findings() {
  const { t } = useTranslation();
  const sentence = useSentence();
  const { look, store } = usePart(DOCTOR);
  const { findings, failure, isLooking, language: said } = useStore(store);
  const language = useSettings((settings) => settings.language);
  // With a board there may be a flight, which comes first: then the station looks only when it is asked to.
  const isIdle = useConnection(({ status }) => status?.board.state === "closed");
  const wantsLook = isIdle && !isLooking && said !== language;
  useEffect(() => {
    if (wantsLook) {
      void look(language);
    }
  }, [wantsLook, look, language]);
  return (
    <Panel title={t("doctor.title")} className="setup-doctor">
      <div className="setup-doctor-head">
        <p>{t("doctor.hint")}</p>
        <Button
          onPress={() => void look(language)}
          state={isLooking ? "pending" : "idle"}
          icon={<RefreshCw aria-hidden="true" size={14} />}
        >
          {t(findings === null ? "doctor.look" : "doctor.lookAgain")}
        </Button>
      </div>
      {isLooking && <Notice level="info">{t("doctor.looking")}</Notice>}
      {failure !== null && !isLooking && <Notice level="error">{sentence(failure)}</Notice>}
      {findings !== null && (
        <ul className="setup-findings" aria-label={t("doctor.findings")}>
          {findings.map((finding) => (
            <Finding key={`${finding.state} ${finding.what}`} finding={finding} />
          ))}
        </ul>
      )}
    </Panel>
  );
}

function Finding({ finding: { state, what, mend } }: { finding: DoctorFinding }) {
  const { t } = useTranslation();
  const Icon = ICONS[state];
  return (
    <li className="setup-finding" data-state={state}>
      <span className="setup-finding-state">
        <Icon aria-hidden="true" size={16} />
        {t(`doctorState.${state}`)}
      </span>
      <div>
        <p>{what}</p>
        {mend !== "" && (
          <p className="setup-finding-mend">
            {t("doctor.mend")} <code>{mend}</code>
          </p>
        )}
      </div>
    </li>
  );
}
