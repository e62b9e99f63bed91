import { Download } from "lucide-react";
import { useEffect, useState } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useSentence } from "../../i18n/useSentence";
import { formatBytes } from "../../lib/format";
import type { Job } from "../../protocol/guards.gen";
import { useAsked } from "../../requests/useAsked";
import { usePart } from "../../store/hooks";
import { failureMessage } from "../../store/messages";
import { Button } from "../../ui/Button";
import { Notice } from "../../ui/Notice";
import { TextField } from "../../ui/TextField";
import { BACKUPS, isUnderWay, LONGEST_PASSWORD, passwordFault, SHORTEST_PASSWORD } from "./backups";

/** Writes all that the station keeps to one encrypted file, which the owner fetches here. */
export function BackupSection() {
  const { t } = useTranslation();
  const sentence = useSentence();
  const { store, watch } = usePart(BACKUPS);
  const job = useStore(store, (state) => state.job);
  const failure = useStore(store, (state) => state.failure);
  useEffect(() => watch(), [watch]);
  return (
    <div className="access-section">
      <p>{t("backup.hint")}</p>
      <PasswordForm isBusy={job !== null && isUnderWay(job)} />
      {failure !== null && <Notice level="error">{sentence(failure)}</Notice>}
      {job !== null && <NewestBackup job={job} />}
      <p>{t("backup.restoreHint")}</p>
    </div>
  );
}

function PasswordForm({ isBusy }: { readonly isBusy: boolean }) {
  const { t } = useTranslation();
  const { make } = usePart(BACKUPS);
  const [password, setPassword] = useState("");
  const [again, setAgain] = useState("");
  const { state, stateText } = useAsked("backup.make");
  const fault = passwordFault(password, again);
  const words =
    fault && t(`backupPassword.${fault}`, { shortest: SHORTEST_PASSWORD, longest: LONGEST_PASSWORD });
  // A field that is empty is not wrong yet.
  const firstError = password !== "" && fault !== null && fault !== "differs" ? words : null;
  const secondError = again !== "" && fault === "differs" ? words : null;

  function begin(): void {
    void make(password, { control: "backup.make" }, () => {
      setPassword("");
      setAgain("");
    });
  }

  return (
    <>
      <div className="access-row access-password">
        <TextField
          label={t("backup.password")}
          value={password}
          onEdit={setPassword}
          onCommit={setPassword}
          error={firstError ?? undefined}
          secret
        />
        <TextField
          label={t("backup.again")}
          value={again}
          onEdit={setAgain}
          onCommit={setAgain}
          error={secondError ?? undefined}
          secret
        />
        <Button
          variant="primary"
          onPress={begin}
          state={state}
          stateText={stateText}
          disabledReason={isBusy ? t("backup.busy") : (words ?? undefined)}
        >
          {t("backup.make")}
        </Button>
      </div>
      {state === "rejected" && <Notice level="error">{stateText}</Notice>}
    </>
  );
}

function NewestBackup({ job }: { readonly job: Job }) {
  const { t } = useTranslation();
  const sentence = useSentence();
  const { cancel } = usePart(BACKUPS);
  const control = "backup.cancel";
  const { state, stateText } = useAsked(control);
  if (job.state === "failed") {
    return (
      <Notice level="error">
        <p>{t("backup.failed")}</p>
        {job.fault !== null && <p>{sentence(failureMessage(job.fault))}</p>}
      </Notice>
    );
  }
  if (isUnderWay(job)) {
    return (
      <div className="access-row access-backup">
        <label>
          <span>{t(job.state === "waiting" ? "backup.waits" : "backup.isMade")}</span>
          <progress max={1} value={job.state === "waiting" ? undefined : job.progress} />
        </label>
        <Button onPress={() => void cancel(job.id, { control })} state={state} stateText={stateText}>
          {t("backup.cancel")}
        </Button>
      </div>
    );
  }
  return job.result === null ? null : (
    <Notice level="info">
      <a className="access-download" href={`/api/v1/jobs/${job.id}/result`} download={job.result.name}>
        <Download size={15} aria-hidden="true" />
        {t("backup.download", { name: job.result.name, bytes: formatBytes(job.result.bytes) })}
      </a>
      <p>{t("backup.keptAnHour")}</p>
    </Notice>
  );
}
