import { Download, X } from "lucide-react";
import { useTranslation } from "react-i18next";
import { useSentence } from "../../i18n/useSentence";
import { formatBytes } from "../../lib/format";
import type { Job } from "../../protocol/guards.gen";
import { useAsked } from "../../requests/useAsked";
import { usePart } from "../../store/hooks";
import { failureMessage } from "../../store/messages";
import { Button } from "../../ui/Button";
import { Notice } from "../../ui/Notice";
import { FLIGHTS, isOver, type Upload } from "./flightLibrary";
import { useLibrary, useLibraryUnreachable } from "./useFlights";

/** Files on their way in and out, with what became of them. */
export function Transfers() {
  const { t } = useTranslation();
  const uploads = useLibrary((library) => library.uploads);
  const jobs = useLibrary((library) => library.jobs);
  const files = useLibrary((library) => library.files);
  const dismissed = useLibrary((library) => library.dismissed);
  const shown = Object.values(jobs).filter((job) => isShown(job, files) && !dismissed.includes(job.id));
  if (uploads.length === 0 && shown.length === 0) {
    return null;
  }
  return (
    <section className="flights-transfers" aria-label={t("flights.transfers")}>
      {uploads.map((upload) => (
        <UploadRow key={upload.key} upload={upload} />
      ))}
      {shown.map((job) => (
        <JobRow key={job.id} job={job} file={files[job.id] ?? null} />
      ))}
    </section>
  );
}

/** An export is fetched from any page of the station; what was brought in elsewhere is in the list. */
function isShown(job: Job, files: Readonly<Record<string, string>>): boolean {
  if (job.state === "cancelled") {
    return false;
  }
  return job.kind === "export"
    ? job.state !== "done" || job.result !== null
    : job.kind === "import" && (job.id in files || !isOver(job));
}

function UploadRow({ upload: { key, name, bytes, sent_bytes, failure } }: { readonly upload: Upload }) {
  const { t } = useTranslation();
  const sentence = useSentence();
  const { cancelUpload } = usePart(FLIGHTS);
  if (failure !== null) {
    return (
      <Notice level="error" onDismiss={() => cancelUpload(key)}>
        <p>{t("flights.notImported", { name })}</p>
        <p>{sentence(failure)}</p>
      </Notice>
    );
  }
  return (
    <div className="flights-transfer">
      <label>
        <span>
          {t("flights.sending", { name, sent: formatBytes(sent_bytes), bytes: formatBytes(bytes) })}
        </span>
        <progress max={Math.max(1, bytes)} value={sent_bytes} />
      </label>
      <Button
        onPress={() => cancelUpload(key)}
        icon={<X size={14} aria-hidden="true" />}
        label={t("flights.cancelOne", { name })}
      >
        {null}
      </Button>
    </div>
  );
}

function JobRow({ job, file }: { readonly job: Job; readonly file: string | null }) {
  const { t } = useTranslation();
  const sentence = useSentence();
  const { dismissJob, select } = usePart(FLIGHTS);
  const name = file ?? job.file ?? job.flight ?? "";
  const isExport = job.kind === "export";
  if (job.state === "failed") {
    return (
      <Notice level="error" onDismiss={() => dismissJob(job.id)}>
        <p>{t(isExport ? "flights.notExported" : "flights.notImported", { name })}</p>
        {job.fault !== null && <p>{sentence(failureMessage(job.fault))}</p>}
      </Notice>
    );
  }
  if (job.state !== "done") {
    return <JobUnderway job={job} name={name} />;
  }
  if (isExport && job.result !== null) {
    return (
      <Notice level="info" onDismiss={() => dismissJob(job.id)}>
        <a className="flights-download" href={`/api/v1/jobs/${job.id}/result`} download={job.result.name}>
          <Download size={15} aria-hidden="true" />
          {t("flights.download", { name: job.result.name, bytes: formatBytes(job.result.bytes) })}
        </a>
      </Notice>
    );
  }
  const { flight } = job;
  return (
    <Notice level="info" onDismiss={() => dismissJob(job.id)}>
      <p>{t("flights.didImport", { name })}</p>
      {flight !== null && <Button onPress={() => select(flight)}>{t("flights.see")}</Button>}
    </Notice>
  );
}

function JobUnderway({ job, name }: { readonly job: Job; readonly name: string }) {
  const { t } = useTranslation();
  const { cancelJob } = usePart(FLIGHTS);
  const control = `flights.job.${job.id}`;
  const { state, stateText } = useAsked(control);
  // Another's job is an operator's to cancel.
  const isOwn = useLibrary(({ ownExports }) => ownExports.includes(job.id));
  const isWaiting = job.state === "waiting";
  const words = job.kind === "export" ? "flights.exporting" : "flights.checking";
  return (
    <div className="flights-transfer">
      <label>
        <span>{isWaiting ? t("flights.jobWaits", { name }) : t(words, { name })}</span>
        <progress max={1} value={isWaiting ? undefined : job.progress} />
      </label>
      <Button
        onPress={() => void cancelJob(job.id, { control })}
        icon={<X size={14} aria-hidden="true" />}
        label={t("flights.cancelOne", { name })}
        state={state}
        stateText={stateText}
        disabledReason={useLibraryUnreachable(isOwn ? "viewer" : "operator")}
      >
        {null}
      </Button>
    </div>
  );
}
