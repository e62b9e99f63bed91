import type { ReactNode } from "react";
import { BoardLink } from "./BoardLink";
import { RawLine } from "./RawLine";
import { RowTable } from "./RowTable";
import "./setup.css";
import { SimulatorLink } from "./SimulatorLink";

/** "Setup": the links to the board and to the simulator, and the raw data on them. */
export function SetupView({ stick, access }: { stick: ReactNode; access: ReactNode }) {
  return (
    <div className="setup">
      <BoardLink />
      <SimulatorLink />
      {stick}
      {access}
      <RawLine />
      <RowTable />
    </div>
  );
}
