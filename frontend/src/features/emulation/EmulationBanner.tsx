import { useTranslation } from "react-i18next";
import { useAsked } from "../../requests/useAsked";
import { useGatewayBlocked } from "../../requests/useBlocked";
import { useConnection, usePart } from "../../store/hooks";
import { Button } from "../../ui/Button";
import { EMULATION } from "./emulationRequests";

interface Emulation {
  /** Example values are being played through the whole path. */
  readonly isOn: boolean;
  /** The line that was open before, to go back to. */
  readonly before_url: string | null;
}

export function useEmulation(): Emulation {
  const isOn = useConnection(({ status }) => status?.board.emulated === true);
  const before_url = useConnection(({ status }) => status?.board.before_emulation_url ?? null);
  return { isOn, before_url };
}

/** Shown over every tab during emulation, so that nobody takes the values for an aircraft's. */
export function EmulationBanner() {
  const { t } = useTranslation();
  const emulation = usePart(EMULATION);
  const { isOn, before_url } = useEmulation();
  const blocked = useGatewayBlocked();
  const { state, stateText } = useAsked("emulation");
  return (
    <div role="status" className="app-emulation" data-shown={isOn}>
      {isOn && (
        <>
          <strong>{t("emulation.banner")}</strong>
          <Button
            onPress={() => void emulation.end(before_url, { control: "emulation" })}
            disabledReason={blocked}
            state={state}
            stateText={stateText}
          >
            {t("emulation.end")}
          </Button>
        </>
      )}
    </div>
  );
}
