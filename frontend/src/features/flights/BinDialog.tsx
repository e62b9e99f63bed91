import { Undo2 } from "lucide-react";
import { useEffect } from "react";
import { useTranslation } from "react-i18next";
import { useSentence } from "../../i18n/useSentence";
import { formatBytes } from "../../lib/format";
import { formatDateTime } from "../../lib/moment";
import type { DeletedFlight } from "../../protocol/guards.gen";
import { useAsked } from "../../requests/useAsked";
import { usePart } from "../../store/hooks";
import { Button } from "../../ui/Button";
import { Dialog } from "../../ui/Dialog";
import { Notice } from "../../ui/Notice";
import { FLIGHTS } from "./flightLibrary";
import { flightName, useLibrary, useLibraryBlocked, usePresent } from "./useFlights";

const MINUTE_S = 60;
const DAY_S = 86_400;

/** The deleted flights, each with the days for which it can still be brought back. */
export function BinDialog({ onClose }: { readonly onClose: () => void }) {
  const { t } = useTranslation();
  const sentence = useSentence();
  const { readBin } = usePart(FLIGHTS);
  const bin = useLibrary((library) => library.bin);
  const failure = useLibrary((library) => library.binFailure);
  useEffect(() => void readBin(), [readBin]);
  return (
    <Dialog title={t("flights.bin")} description={t("flights.binText")} onClose={onClose} size="wide">
      {failure !== null && <Notice level="error">{sentence(failure)}</Notice>}
      {bin === null ? (
        <p className="flights-quiet">{t("window.loading")}</p>
      ) : bin.length === 0 ? (
        <p className="flights-quiet">{t("flights.binEmpty")}</p>
      ) : (
        <ul className="flights-bin">
          {bin.map((flight) => (
            <Deleted key={flight.id} flight={flight} />
          ))}
        </ul>
      )}
    </Dialog>
  );
}

function Deleted({ flight }: { readonly flight: DeletedFlight }) {
  const { t } = useTranslation();
  const now_s = usePresent(({ status }) => Math.ceil((status?.server_time_s ?? 0) / MINUTE_S) * MINUTE_S);
  const days = Math.max(0, Math.ceil((flight.gone_s - now_s) / DAY_S));
  return (
    <li>
      <span>
        <strong>{flightName(flight)}</strong>
        <span className="flights-quiet">
          {`${formatDateTime(flight.started_s)} · ${formatBytes(flight.bytes)} · ${t("flights.daysLeft", { count: days })}`}
        </span>
      </span>
      <RestoreButton flight={flight} />
    </li>
  );
}

export function RestoreButton({
  flight,
}: {
  readonly flight: Pick<DeletedFlight, "id" | "title" | "started_s">;
}) {
  const { t } = useTranslation();
  const { restore } = usePart(FLIGHTS);
  const control = `flights.restore.${flight.id}`;
  const { state, stateText } = useAsked(control);
  return (
    <Button
      onPress={() => void restore(flight.id, { control })}
      icon={<Undo2 size={15} aria-hidden="true" />}
      label={t("flights.restoreOne", { name: flightName(flight) })}
      state={state}
      stateText={stateText}
      disabledReason={useLibraryBlocked("owner")}
    >
      {t("flights.restore")}
    </Button>
  );
}
