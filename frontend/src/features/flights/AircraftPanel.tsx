import { useTranslation } from "react-i18next";
import { useAsked } from "../../requests/useAsked";
import { usePart } from "../../store/hooks";
import { Notice } from "../../ui/Notice";
import { Panel } from "../../ui/Panel";
import { TextField } from "../../ui/TextField";
import { FLIGHTS } from "./flightLibrary";
import { useLibraryBlocked } from "./useFlights";

/** The longest name that the station keeps. */
const LONGEST_NAME = 60;

/** What the aircraft is called: no line says it, so a person does. */
export function AircraftPanel({ aircraft }: { readonly aircraft: string }) {
  const { t } = useTranslation();
  const { setAircraft } = usePart(FLIGHTS);
  const control = "flights.aircraft";
  const { state, stateText } = useAsked(control);
  return (
    <Panel title={t("flights.aircraft")} className="flights-aircraft">
      <TextField
        label={t("flights.aircraftName")}
        hint={t("flights.aircraftHint")}
        value={aircraft}
        disabledReason={useLibraryBlocked("operator")}
        onCommit={(name) => void setAircraft(name.trim().slice(0, LONGEST_NAME), { control })}
      />
      {state === "rejected" && <Notice level="error">{stateText}</Notice>}
    </Panel>
  );
}
