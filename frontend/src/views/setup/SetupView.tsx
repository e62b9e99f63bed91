import { BoardLink } from "./BoardLink";
import "./setup.css";
import { SimulatorLink } from "./SimulatorLink";

/** "Setup": the two lines of the station, to the board and to the simulator. */
export function SetupView() {
  return (
    <div className="setup">
      <BoardLink />
      <SimulatorLink />
    </div>
  );
}
