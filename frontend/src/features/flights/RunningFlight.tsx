import { Rewind } from "lucide-react";
import { useTranslation } from "react-i18next";
import { formatBytes } from "../../lib/format";
import { formatDateTime, formatFlightTime } from "../../lib/moment";
import { usePart } from "../../store/hooks";
import { Button } from "../../ui/Button";
import { FLIGHTS } from "./flightLibrary";
import { runningFlight } from "./runningFlight";
import { useLibraryUnreachable, usePresent } from "./useFlights";

/** The flight that is being recorded, with its size as it grows. */
export function RunningFlight() {
  const { t } = useTranslation();
  const flights = usePart(FLIGHTS);
  const unreachable = useLibraryUnreachable();
  // Compared as text, so that nothing is drawn while nothing grows.
  const shown = usePresent((connection) => {
    const running = runningFlight(connection);
    return running === null
      ? null
      : [
          formatDateTime(running.started_s),
          formatFlightTime(running.duration_s),
          formatBytes(running.bytes),
        ].join("|");
  });
  if (shown === null) {
    return null;
  }
  const [started, duration, bytes] = shown.split("|");
  return (
    <section className="flights-running" aria-label={t("flights.running")}>
      <span className="flights-running-lamp" aria-hidden="true" />
      <strong>{t("flights.running")}</strong>
      <span>{started}</span>
      <span className="flights-number">{duration}</span>
      <span className="flights-number">{bytes}</span>
      <Button
        onPress={() => flights.open("current", 0)}
        icon={<Rewind size={14} aria-hidden="true" />}
        disabledReason={unreachable}
      >
        {t("flights.openRunning")}
      </Button>
    </section>
  );
}
