import type { ReactNode } from "react";
import { BoardLink } from "./BoardLink";
import { RawLine } from "./RawLine";
import { RowTable } from "./RowTable";
import "./setup.css";
import { SimulatorLink } from "./SimulatorLink";

/** "Setup": the two lines of the station, to the board and to the simulator, and what goes over them as it is. */
export function SetupView({ stick }: { stick: ReactNode }) {
  return (
    <div className="setup">
      <BoardLink />
      <SimulatorLink />
      {stick}
      <RawLine />
      <RowTable />
    </div>
  );
}
