import { screen } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { expect, test } from "vitest";
import type { FaultState } from "../../protocol/guards.gen";
import { aStatus } from "../../test/aStatus";
import { aShape } from "../../test/shapes";
import { Station } from "../../test/station";
import { Part } from "../../test/tab";
import { FaultsNow } from "./FaultsNow";

const user = userEvent.setup();

function flying(...faults: readonly Partial<FaultState>[]): ReturnType<typeof aStatus> {
  const { simulator, server_time_s } = aStatus();
  const usual = { id: "a", begins_s: server_time_s, ends_s: null, is_on: true, strength: null, unit: "" };
  const flown = {
    faults: faults.map((parts) => aShape("FaultState", { ...usual, ...parts })),
    wind: { from_deg: 0, speed_kt: 0, turbulence: "none" as const },
  };
  return aStatus({ simulator: { ...simulator, faults: flown } });
}

async function seenBy(role: string, status: ReturnType<typeof aStatus>): Promise<Station> {
  const station = new Station(
    <Part>
      <FaultsNow />
    </Part>,
  );
  station.greet(status);
  const me = { state: "in", kind: "local", role, name: "local", anyone_may_fly: false };
  await station.askedAccess
    .filter(({ path }) => path.endsWith("/me"))
    .at(-1)
    ?.answer(me);
  return station;
}

const JAMMED = { place: "elevator", kind: "jammed", strength: 0.2, unit: "of half its travel" } as const;
const END_ALL = "Terminar todos los fallos";

test("everybody reads what is wrong in the simulator now, and a viewer has nothing to press there", async () => {
  await seenBy("viewer", flying(JAMMED, { id: "b", place: "engine", kind: "out" }));
  expect(screen.getByRole("status").textContent).toBe(
    "Fallos en curso: Elevador: bloqueo, 20 % de medio recorrido y 1 más",
  );
  expect(screen.queryByRole("button")).toBeNull();
});

test("one fault is said alone, one that waits is not said, and nothing is said of a station that is gone", async () => {
  const station = await seenBy("viewer", flying({ place: "engine", kind: "out", is_on: false }));
  expect(screen.getByRole("status").textContent).toBe("");
  station.status(flying({ place: "engine", kind: "out" }));
  await expect.poll(() => screen.getByRole("status").textContent).toBe("Fallo en curso: Motor: parada");
  station.breakOff();
  await expect.poll(() => screen.getByRole("status").textContent).toBe("");
});

test("an owner ends all of it from there", async () => {
  const station = await seenBy("owner", flying(JAMMED));
  await user.click(screen.getByRole("button", { name: END_ALL }));
  expect(station.asked.filter(({ method }) => method === "DELETE").map(({ path }) => path)).toEqual([
    "/api/v1/faults",
  ]);
});
