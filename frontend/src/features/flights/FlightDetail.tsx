import { ChevronLeft, FileOutput, FileText, RefreshCw, Route, Trash2 } from "lucide-react";
import { useState } from "react";
import { useTranslation } from "react-i18next";
import { useSentence } from "../../i18n/useSentence";
import { formatDateTime } from "../../lib/moment";
import { ImportQuestions } from "../../missions/ImportQuestions";
import type { Flight } from "../../protocol/guards.gen";
import { useAsked } from "../../requests/useAsked";
import { operatorName } from "../../requests/useControl";
import { usePart } from "../../store/hooks";
import { failureMessage } from "../../store/messages";
import { Button } from "../../ui/Button";
import { ConfirmDialog } from "../../ui/ConfirmDialog";
import { Notice } from "../../ui/Notice";
import { Panel } from "../../ui/Panel";
import { AsPlanDialog } from "./AsPlanDialog";
import { ExportDialog } from "./ExportDialog";
import { OpenButton, PinButton } from "./FlightRow";
import { FlightStory } from "./FlightStory";
import { FlightWordsForm } from "./FlightWordsForm";
import { FLIGHTS } from "./flightLibrary";
import { useFlightFigures } from "./useFlightFigures";
import { flightName, useLibraryBlocked, useLibraryUnreachable } from "./useFlights";

/** All that is known of the selected flight, and all that can be done with it. */
export function FlightDetail({ flight }: { readonly flight: Flight }) {
  const { t } = useTranslation();
  const { select } = usePart(FLIGHTS);
  return (
    <section className="flights-detail" aria-label={t("flights.detail", { name: flightName(flight) })}>
      <div className="flights-back">
        <Button onPress={() => select(null)} icon={<ChevronLeft size={15} aria-hidden="true" />}>
          {t("flights.back")}
        </Button>
      </div>
      <header className="flights-detail-head">
        <h2>{flightName(flight)}</h2>
        <p className="flights-quiet">{`${formatDateTime(flight.started_s)} · ${flight.id}`}</p>
      </header>
      <Faults flight={flight} />
      <Tools flight={flight} />
      <Facts flight={flight} />
      <FlightWordsForm flight={flight} />
      <Panel title={t("flights.events")} level={3}>
        <FlightStory flight={flight} />
      </Panel>
    </section>
  );
}

/** What is wrong with the recording, in a sentence. */
function Faults({ flight }: { readonly flight: Flight }) {
  const { fault, damage, copies, state, log, clock_ahead_s, clock_unsure } = flight;
  const { t } = useTranslation();
  const sentence = useSentence();
  return (
    <>
      {state === "waiting" && <Notice level="info">{t("flights.waits")}</Notice>}
      {state === "indexing" && <Notice level="info">{t("flights.preparing")}</Notice>}
      {fault !== null && <Notice level="warning">{sentence(failureMessage(fault))}</Notice>}
      {log !== null && <Notice level="info">{t("flights.log", { what: t(`logKind.${log}`) })}</Notice>}
      {damage !== null && (
        <Notice level={log === null ? "warning" : "info"}>
          {t(log === null ? "flights.damage" : "flights.leftOut", { why: damage })}
        </Notice>
      )}
      {copies.length > 0 && (
        <Notice level="info">
          {t("flights.copies", { count: copies.length, files: copies.map((id) => `${id}.mcap`).join(", ") })}
        </Notice>
      )}
      {clock_ahead_s !== 0 && <Notice level="info">{t("flights.clockCorrected")}</Notice>}
      {clock_ahead_s === 0 && clock_unsure && <Notice level="info">{t("flights.clockUnsure")}</Notice>}
    </>
  );
}

function Tools({ flight }: { readonly flight: Flight }) {
  const { t } = useTranslation();
  const { remove, indexAgain, openReport } = usePart(FLIGHTS);
  const [asks, setAsks] = useState<"export" | "plan" | "delete" | null>(null);
  const deleting = { control: `flights.delete.${flight.id}` };
  const indexing = { control: `flights.index.${flight.id}` };
  const deleted = useAsked(deleting.control);
  const indexed = useAsked(indexing.control);
  const unreachable = useLibraryUnreachable();
  const changing = useLibraryUnreachable("operator");
  const name = flightName(flight);
  const when = formatDateTime(flight.started_s);
  return (
    <div className="flights-tools">
      <OpenButton flight={flight} />
      <PinButton flight={flight} />
      <Button
        onPress={() => openReport(flight.id)}
        icon={<FileText size={15} aria-hidden="true" />}
        disabledReason={flight.state === "indexed" ? unreachable : t("flights.notReady")}
      >
        {t("report.open")}
      </Button>
      <Button
        onPress={() => setAsks("export")}
        icon={<FileOutput size={15} aria-hidden="true" />}
        disabledReason={flight.state === "indexed" ? unreachable : t("flights.notReady")}
      >
        {t("flights.export")}
      </Button>
      <Button
        onPress={() => setAsks("plan")}
        icon={<Route size={15} aria-hidden="true" />}
        disabledReason={flight.state === "indexed" ? unreachable : t("flights.notReady")}
      >
        {t("flights.asPlan")}
      </Button>
      <Button
        onPress={() => void indexAgain(flight.id, indexing)}
        icon={<RefreshCw size={15} aria-hidden="true" />}
        label={t("flights.indexAgain")}
        state={indexed.state}
        stateText={indexed.stateText}
        disabledReason={changing}
      >
        {null}
      </Button>
      <Button
        variant="danger"
        onPress={() => setAsks("delete")}
        icon={<Trash2 size={15} aria-hidden="true" />}
        state={deleted.state}
        stateText={deleted.stateText}
        disabledReason={useLibraryBlocked("owner")}
      >
        {t("flights.delete")}
      </Button>
      {asks === "export" && <ExportDialog flight={flight} onClose={() => setAsks(null)} />}
      {asks === "plan" && <AsPlanDialog flight={flight} onClose={() => setAsks(null)} />}
      <ImportQuestions plan="flight" />
      <ImportQuestions plan="hil" />
      {asks === "delete" && (
        <ConfirmDialog
          title={t("flights.deleteTitle")}
          text={
            flight.title === ""
              ? t("flights.deleteText", { name: when })
              : t("flights.deleteText", { name: `${name} (${when})` })
          }
          confirmLabel={t("flights.deleteYes")}
          cancelLabel={t("flights.keep")}
          danger
          onCancel={() => setAsks(null)}
          onConfirm={() => {
            setAsks(null);
            void remove(flight, deleting);
          }}
        />
      )}
    </div>
  );
}

function Facts({ flight }: { readonly flight: Flight }) {
  const { t } = useTranslation();
  const figures = useFlightFigures()(flight);
  const facts = [
    ...figures.map(({ label, text }) => [label, text] as const),
    [t("flights.waypoints"), flight.waypoints === null ? null : String(flight.waypoints)] as const,
    [t("flights.board"), flight.board] as const,
    [t("flights.firmware"), flight.firmware] as const,
    [t("flights.aircraft"), flight.aircraft] as const,
    [t("flights.operator"), operatorName(t, flight.operator)] as const,
    [t("flights.station"), flight.station] as const,
  ];
  return (
    <dl className="flights-known">
      {facts.map(([label, text]) => (
        <div key={label}>
          <dt>{label}</dt>
          <dd>{text === null || text === "" ? "—" : text}</dd>
        </div>
      ))}
    </dl>
  );
}
