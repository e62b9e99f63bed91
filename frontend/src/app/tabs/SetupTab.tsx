import { StickPanel } from "../../features/gamepad/StickPanel";
import { SetupView } from "../../features/setup/SetupView";

/** "Setup", with the choice of the pilot's stick in its place. */
export function SetupTab() {
  return <SetupView stick={<StickPanel />} />;
}
