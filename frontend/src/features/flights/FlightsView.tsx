import { Trash2, Upload } from "lucide-react";
import { useEffect, useState } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useSentence } from "../../i18n/useSentence";
import { usePart } from "../../store/hooks";
import { Button } from "../../ui/Button";
import { FileButton } from "../../ui/FileButton";
import { Notice } from "../../ui/Notice";
import { AircraftPanel } from "./AircraftPanel";
import { BinDialog, RestoreButton } from "./BinDialog";
import { DiskPanel } from "./DiskPanel";
import { FlightDetail } from "./FlightDetail";
import { FlightDrop } from "./FlightDrop";
import { FlightFilters } from "./FlightFilters";
import { FlightPages, FlightRows } from "./FlightRows";
import { FLIGHT_COMPARISON } from "./flightComparison";
import { FLIGHTS, RECORDING_FILES } from "./flightLibrary";
import { isFiltered } from "./flightQuery";
import { RunningFlight } from "./RunningFlight";
import { Transfers } from "./Transfers";
import { flightName, useLibrary, useLibraryBlocked } from "./useFlights";
import "./flight-detail.css";
import "./flights.css";

/** The tab of the recorded flights. */
export function FlightsView() {
  const { t } = useTranslation();
  const sentence = useSentence();
  const { watch } = usePart(FLIGHTS);
  useEffect(() => watch(), [watch]);
  const list = useLibrary((library) => library.list);
  const failure = useLibrary((library) => library.failure);
  const query = useLibrary((library) => library.query);
  const selected = useLibrary((library) => library.selected);
  const flight = list?.flights.find(({ id }) => id === selected) ?? null;
  const past = list?.flights.filter(({ active }) => !active) ?? [];
  return (
    <FlightDrop>
      <div className="flights-head">
        <FlightFilters />
        <HeadTools />
      </div>
      <div className="flights-body" data-selected={flight !== null} data-empty={past.length === 0}>
        <div className="flights-main">
          {failure !== null && <Notice level="error">{sentence(failure)}</Notice>}
          <RunningFlight />
          <JustDeleted />
          <Transfers />
          {list === null ? (
            failure === null && <p className="flights-quiet">{t("window.loading")}</p>
          ) : (
            <>
              <Unnamed files={list.unnamed} />
              <FlightPages />
              {past.length > 0 && <FlightRows flights={past} />}
              {past.length === 0 && (isFiltered(query) ? <NothingFound /> : <NothingYet />)}
              <AircraftPanel aircraft={list.aircraft} />
              <DiskPanel disk={list.disk} />
            </>
          )}
        </div>
        {flight === null ? (
          past.length > 0 && <p className="flights-choose">{t("flights.choose")}</p>
        ) : (
          <FlightDetail key={flight.id} flight={flight} />
        )}
      </div>
    </FlightDrop>
  );
}

function HeadTools() {
  const { t } = useTranslation();
  const { importFile } = usePart(FLIGHTS);
  const blocked = useLibraryBlocked("operator");
  const [isBinOpen, setBinOpen] = useState(false);
  return (
    <div className="flights-head-tools">
      <CompareButtons />
      <FileButton
        onFile={(file) => void importFile(file)}
        accept={RECORDING_FILES}
        icon={<Upload size={15} aria-hidden="true" />}
        disabledReason={blocked}
      >
        {t("flights.import")}
      </FileButton>
      <Button onPress={() => setBinOpen(true)} icon={<Trash2 size={15} aria-hidden="true" />}>
        {t("flights.bin")}
      </Button>
      {isBinOpen && <BinDialog onClose={() => setBinOpen(false)} />}
    </div>
  );
}

/** One button for each view that can lay two flights side by side. */
function CompareButtons() {
  const { t } = useTranslation();
  const views = useStore(usePart(FLIGHT_COMPARISON).views);
  const [first, second] = useLibrary((library) => library.compared);
  return views.map(({ words, open }) => (
    <Button
      key={words}
      onPress={() => first !== undefined && second !== undefined && open(first, second)}
      disabledReason={second === undefined ? t("flights.chooseTwo") : undefined}
    >
      {t(words as "flights.compare")}
    </Button>
  ));
}

/** Recordings that were renamed in their folder. */
function Unnamed({ files }: { files: readonly string[] }) {
  const { t } = useTranslation();
  return files.length === 0 ? null : (
    <Notice level="warning">{t("flights.unnamed", { count: files.length, names: files.join(", ") })}</Notice>
  );
}

function JustDeleted() {
  const { t } = useTranslation();
  const deleted = useLibrary((library) => library.deleted);
  return deleted.map((flight) => (
    <div key={flight.id} className="flights-deleted" role="status">
      <span>{t("flights.deleted", { name: flightName(flight) })}</span>
      <RestoreButton flight={flight} />
    </div>
  ));
}

function NothingFound() {
  const { t } = useTranslation();
  return <p className="flights-quiet">{t("flights.nothingFound")}</p>;
}

/** At first start: what will be here. */
function NothingYet() {
  const { t } = useTranslation();
  return (
    <div className="flights-empty">
      <h2>{t("flights.emptyTitle")}</h2>
      <p>{t("flights.emptyText")}</p>
      <p>{t("flights.emptyImport")}</p>
    </div>
  );
}
