import { formatBytes } from "../../lib/format";
import { isJob, isJobStart, type Job } from "../../protocol/guards.gen";
import { type Gateway, info, type Requester } from "../../requests/asking";
import { failureMessage, type Message } from "../../store/messages";
import type { Flights, LibraryStore, Upload } from "./flightLibrary";

interface Parts {
  readonly rest: Gateway;
  readonly store: LibraryStore;
  readonly run: Requester["run"];
  /** A job as the gateway has it now. */
  readonly onJob: (job: Job) => void;
  /** This page asked for an export. */
}

/** Files to and from the library: sending recordings, exports and their jobs. */
export function createFlightTransfers({
  rest,
  store,
  run,
  onJob,
}: Parts): Pick<Flights, "importFile" | "cancelUpload" | "export" | "cancelJob" | "dismissJob"> {
  const cancels = new Map<number, AbortController>();
  let next = 0;

  function change(key: number, part: Partial<Upload>): void {
    store.setState(({ uploads }) => ({
      uploads: uploads.map((upload) => (upload.key === key ? { ...upload, ...part } : upload)),
    }));
  }

  async function readJob(id: string): Promise<void> {
    const answer = await rest.ask("GET", `/api/v1/jobs/${id}`, isJob);
    if (answer.ok) {
      onJob(answer.value);
    }
  }

  function forget(key: number): void {
    cancels.delete(key);
    store.setState(({ uploads }) => ({ uploads: uploads.filter((upload) => upload.key !== key) }));
  }

  return {
    importFile: async (file) => {
      next += 1;
      const key = next;
      const controller = new AbortController();
      cancels.set(key, controller);
      const { name, size } = file;
      const most_bytes = store.getState().list?.disk.most_import_bytes ?? Number.POSITIVE_INFINITY;
      // A gateway that refuses a file while it is being sent cannot be heard: the browser reports a broken line alone.
      const failure = size > most_bytes ? tooLarge(size, most_bytes) : null;
      const begun: Upload = { key, name, bytes: size, sent_bytes: 0, failure };
      store.setState(({ uploads }) => ({ uploads: [begun, ...uploads] }));
      if (failure !== null) {
        return;
      }
      const path = `/api/v1/flights?name=${encodeURIComponent(name)}`;
      const answer = await rest.upload(path, isJobStart, {
        body: file,
        onSent: (sent_bytes) => change(key, { sent_bytes }),
        signal: controller.signal,
      });
      if (answer.ok) {
        forget(key);
        store.setState(({ files }) => ({ files: { ...files, [answer.value.job]: name } }));
        // The job may have ended before its name was known here.
        await readJob(answer.value.job);
      } else if (controller.signal.aborted) {
        forget(key);
      } else {
        change(key, { failure: failureMessage(answer.problem) });
      }
    },

    cancelUpload: (key) => {
      cancels.get(key)?.abort();
      forget(key);
    },

    export: (flight, { format, lang, every_point, from_s, to_s }, asker) =>
      run(
        asker,
        rest.ask("POST", `/api/v1/flights/${flight}/exports`, isJobStart, {
          format,
          lang,
          every_point,
          topics: null,
          from_s,
          to_s,
        }),
        ({ job }) => {
          store.setState(({ ownExports }) => ({ ownExports: [...ownExports, job] }));
          void readJob(job);
          return { state: "confirmed", message: info("flights.saidExporting") };
        },
      ),

    cancelJob: (id, asker) =>
      run(asker, rest.ask("DELETE", `/api/v1/jobs/${id}`, isJob), (job) => {
        onJob(job);
        return { state: "confirmed", message: info("flights.saidCancelled") };
      }),

    dismissJob: (id) => store.setState(({ dismissed }) => ({ dismissed: [...dismissed, id] })),
  };
}

function tooLarge(bytes: number, most_bytes: number): Message {
  const params = { bytes: formatBytes(bytes), most: formatBytes(most_bytes) };
  return { level: "error", key: "flights.tooLarge", params };
}
