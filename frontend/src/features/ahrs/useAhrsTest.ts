import { useTranslation } from "react-i18next";
import { useBoardBlocked } from "../../requests/useBlocked";
import { useConnection, useTelemetry } from "../../store/hooks";

export type AhrsTestStage = "off" | "starting" | "running" | "ending";

export function useAhrsTestStage(): AhrsTestStage {
  return useConnection(({ status }) => status?.board.ahrs_test ?? "off");
}

/** Why the AHRS test cannot start now; the gateway checks again on the request. */
export function useAhrsTestBlocked(): string | undefined {
  const { t } = useTranslation();
  const blocked = useBoardBlocked();
  const isEmulated = useConnection(({ status }) => status?.board.emulated === true);
  const movesSimulator = useConnection(
    ({ status }) => status?.simulator.state === "open" && status.hil.path === "assisted",
  );
  const hasAutopilot = useTelemetry(
    (telemetry) =>
      telemetry.newestFlag("heartbeat", "autopilot") === true ||
      telemetry.newestFlag("heartbeat", "autopilot_hil") === true,
  );
  if (blocked !== undefined) {
    return blocked;
  }
  if (isEmulated) {
    return t("ahrs3d.noTestInEmulation");
  }
  return movesSimulator || hasAutopilot ? t("problem.ahrs_test_in_flight") : undefined;
}
