import { useTranslation } from "react-i18next";
import { useAsked } from "../../requests/useAsked";
import { useGatewayBlocked } from "../../requests/useBlocked";
import { usePart } from "../../store/hooks";
import { Button } from "../../ui/Button";
import { AHRS } from "./alignment";
import { useAhrsTestStage } from "./useAhrsTest";

/** Shown over every tab during the AHRS test: says that all other streams are silent on purpose, and ends the test. */
export function AhrsTestBanner() {
  const { t } = useTranslation();
  const ahrs3d = usePart(AHRS);
  const isRunning = useAhrsTestStage() === "running";
  const blocked = useGatewayBlocked();
  const { state, stateText } = useAsked("ahrsTest");
  return (
    <div role="status" className="app-emulation" data-shown={isRunning}>
      {isRunning && (
        <>
          <strong>{t("ahrs3d.banner")}</strong>
          <Button
            onPress={() => void ahrs3d.stopTest({ control: "ahrsTest" })}
            disabledReason={blocked}
            state={state}
            stateText={stateText}
          >
            {t("ahrs3d.end")}
          </Button>
        </>
      )}
    </div>
  );
}
