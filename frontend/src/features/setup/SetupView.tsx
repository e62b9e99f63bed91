import type { ReactNode } from "react";
import { BoardLink } from "./BoardLink";
import { DoctorPanel } from "./DoctorPanel";
import { RawLine } from "./RawLine";
import { RowTable } from "./RowTable";
import "./setup.css";
import { SimulatorLink } from "./SimulatorLink";

/** "Setup": the links to the board and to the simulator, the raw data on them, and what is wrong with the computer. */
export function SetupView({ stick, access }: { stick: ReactNode; access: ReactNode }) {
  return (
    <div className="setup">
      <BoardLink />
      <SimulatorLink />
      {stick}
      {access}
      <DoctorPanel />
      <RawLine />
      <RowTable />
    </div>
  );
}
