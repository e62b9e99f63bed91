import { AccessPanel } from "../../features/access/AccessPanel";
import { FaultPanel } from "../../features/faults/FaultPanel";
import { StickPanel } from "../../features/gamepad/StickPanel";
import { SetupView } from "../../features/setup/SetupView";

/** "Setup", with the choice of the pilot's stick and who may come in, each in its place. */
export function SetupTab() {
  return <SetupView stick={<StickPanel />} access={<AccessPanel />} faults={<FaultPanel />} />;
}
