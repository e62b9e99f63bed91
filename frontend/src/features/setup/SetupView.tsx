import type { ReactNode } from "react";
import { BoardLink } from "./BoardLink";
import { DoctorPanel } from "./DoctorPanel";
import { RawLine } from "./RawLine";
import { RowTable } from "./RowTable";
import "./setup.css";
import { SimulatorLink } from "./SimulatorLink";

interface Props {
  readonly stick: ReactNode;
  readonly access: ReactNode;
  readonly faults: ReactNode;
}

/** "Setup": the links to the board and to the simulator, the raw data on them, and what is wrong with the computer. */
export function SetupView({ stick, access, faults }: Props) {
  return (
    <div className="setup">
      <BoardLink />
      <SimulatorLink />
      {stick}
      {access}
      {faults}
      <DoctorPanel />
      <RawLine />
      <RowTable />
    </div>
  );
}
