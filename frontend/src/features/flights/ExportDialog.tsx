import { useState } from "react";
import { useTranslation } from "react-i18next";
import type { Flight } from "../../protocol/guards.gen";
import { usePart, useSettings } from "../../store/hooks";
import { Button } from "../../ui/Button";
import { Checkbox } from "../../ui/Checkbox";
import { Dialog } from "../../ui/Dialog";
import { NumberField } from "../../ui/NumberField";
import { EXPORT_FORMATS, type ExportFormat, FLIGHTS } from "./flightLibrary";
import { flightName, useLibraryUnreachable } from "./useFlights";

/** Formats that leave out what is within a metre of the track, unless every point is asked for. */
const THINNED: ReadonlySet<ExportFormat> = new Set(["kml", "kmz", "gpx"]);

/** What to turn a flight into: the format, with what it is for, and which stretch. */
export function ExportDialog({ flight, onClose }: { readonly flight: Flight; readonly onClose: () => void }) {
  const { t } = useTranslation();
  const lang = useSettings(({ language }) => language);
  const flights = usePart(FLIGHTS);
  const whole_s = Math.ceil(flight.duration_s ?? 0);
  const [format, setFormat] = useState<ExportFormat>(EXPORT_FORMATS[0]);
  const [everyPoint, setEveryPoint] = useState(false);
  const [isPart, setPart] = useState(false);
  const [from_s, setFrom] = useState(0);
  const [to_s, setTo] = useState(whole_s);
  const unreachable = useLibraryUnreachable();
  const wrong = isPart && from_s >= to_s ? t("flights.emptyStretch") : undefined;

  function start(): void {
    const part = isPart ? { from_s, to_s } : { from_s: null, to_s: null };
    const wish = { format, lang, every_point: everyPoint && THINNED.has(format), ...part };
    void flights.export(flight.id, wish, { control: "flights.export" });
    onClose();
  }

  return (
    <Dialog
      title={t("flights.exportTitle", { name: flightName(flight) })}
      onClose={onClose}
      actions={
        <>
          <Button onPress={onClose}>{t("flights.cancel")}</Button>
          <Button takesFields variant="primary" onPress={start} disabledReason={unreachable ?? wrong}>
            {t("flights.exportStart")}
          </Button>
        </>
      }
    >
      <fieldset className="flights-formats">
        <legend className="ui-field-label">{t("flights.format")}</legend>
        {EXPORT_FORMATS.map((one) => (
          <label key={one} className="flights-format">
            <input
              type="radio"
              name="flights-format"
              checked={format === one}
              onChange={() => setFormat(one)}
            />
            <span>
              <strong>{t(`exportFormat.${one}`)}</strong>
              <span className="flights-quiet">{t(`exportUse.${one}`)}</span>
            </span>
          </label>
        ))}
      </fieldset>
      {THINNED.has(format) && (
        <div className="flights-every-point">
          <Checkbox label={t("flights.everyPoint")} checked={everyPoint} onChange={setEveryPoint} />
          <p className="flights-quiet">{t("flights.everyPointHint")}</p>
        </div>
      )}
      {whole_s > 0 && <Checkbox label={t("flights.onlyPart")} checked={isPart} onChange={setPart} />}
      {isPart && (
        <div className="flights-stretch">
          <NumberField
            label={t("flights.fromSecond")}
            unit={t("unit.s")}
            value={from_s}
            minimum={0}
            maximum={whole_s}
            step={1}
            onCommit={setFrom}
          />
          <NumberField
            label={t("flights.toSecond")}
            unit={t("unit.s")}
            value={to_s}
            minimum={0}
            maximum={whole_s}
            step={1}
            onCommit={setTo}
          />
        </div>
      )}
    </Dialog>
  );
}
