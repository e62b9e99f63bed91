import { useState } from "react";
import { useTranslation } from "react-i18next";
import { LiveBadge, StreamOff, useStreamIsOff } from "../../readouts/StreamPanel";
import { useAsked } from "../../requests/useAsked";
import { useGatewayBlocked } from "../../requests/useBlocked";
import { usePart } from "../../store/hooks";
import { Button } from "../../ui/Button";
import { ConfirmDialog } from "../../ui/ConfirmDialog";
import { Panel } from "../../ui/Panel";
import type { AttitudeSource } from "./alignment";
import { AHRS } from "./alignment";
import { useAhrsTestBlocked, useAhrsTestStage } from "./useAhrsTest";

/** Which stream turns the aircraft, how fresh it is, and the switch to the other one. */
export function SourcePanel({ source }: { source: AttitudeSource }) {
  const { t } = useTranslation();
  const isOff = useStreamIsOff("ahrs") && source === "ahrs";
  return (
    <Panel
      title={t("ahrs3d.source")}
      badge={isOff ? undefined : <LiveBadge topic={source} />}
      actions={isOff ? <StreamOff topic="ahrs" narrow={false} /> : undefined}
    >
      <p>{t(source === "ahrs" ? "ahrs3d.sourceFrames" : "ahrs3d.sourceTest")}</p>
      <div className="ahrs3d-row">
        <TestSwitch />
      </div>
    </Panel>
  );
}

function TestSwitch() {
  const { t } = useTranslation();
  const ahrs3d = usePart(AHRS);
  const stage = useAhrsTestStage();
  const [isAsking, setAsking] = useState(false);
  const startBlocked = useAhrsTestBlocked();
  const stopBlocked = useGatewayBlocked();
  const { state, stateText } = useAsked("ahrsTest");
  const isRunning = stage === "running";
  return (
    <>
      <Button
        onPress={() => (isRunning ? void ahrs3d.stopTest({ control: "ahrsTest" }) : setAsking(true))}
        state={state}
        stateText={stateText}
        disabledReason={isRunning ? stopBlocked : startBlocked}
      >
        {t(isRunning ? "command.ahrs_test_stop" : "command.ahrs_test_start")}
      </Button>
      {isAsking && (
        <ConfirmDialog
          title={t("command.ahrs_test_start")}
          text={t("ahrs3d.startText")}
          confirmLabel={t("ahrs3d.start")}
          cancelLabel={t("ahrs3d.cancel")}
          onConfirm={() => {
            setAsking(false);
            void ahrs3d.startTest({ control: "ahrsTest" });
          }}
          onCancel={() => setAsking(false)}
        />
      )}
    </>
  );
}
