import { act, screen, within } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { expect, test } from "vitest";
import { aStatus } from "../../test/aStatus";
import { type FakeRequest, Station } from "../../test/station";
import { Tab } from "../../test/tab";

const user = userEvent.setup();
const closed = aStatus({ board: { ...aStatus().board, state: "closed" } });
const FINDINGS = [
  { state: "ok", what: "82 GB libres en su disco", mend: "" },
  { state: "fault", what: "El puerto UDP 49003 lo usa otro programa.", mend: "sudo ss -ulpn" },
];

async function setup(role: string, status = closed): Promise<Station> {
  const station = new Station(<Tab name="setup" />);
  station.greet(status);
  const me = { state: "in", kind: "local", role, name: "local", anyone_may_fly: false };
  await station.askedAccess
    .filter(({ path }) => path.endsWith("/me"))
    .at(-1)
    ?.answer(me);
  return station;
}

function looks(station: Station): readonly FakeRequest[] {
  return station.asked.filter(({ path }) => path.startsWith("/api/v1/doctor"));
}

function panel(): HTMLElement {
  return screen.getByRole("region", { name: "El ordenador de la estación" });
}

test("an owner without a board sees at once what was looked at, what was found and what to do", async () => {
  const station = await setup("owner");
  expect(looks(station).map(({ path }) => path)).toEqual(["/api/v1/doctor?lang=es"]);
  expect(within(panel()).getByText(/Se está mirando/)).toBeDefined();
  await looks(station)[0]?.answer({ findings: FINDINGS });
  expect(within(panel()).queryByText(/Se está mirando/)).toBeNull();
  const rows = within(panel()).getAllByRole("listitem");
  expect(rows.map(({ textContent }) => textContent)).toEqual([
    "En orden82 GB libres en su disco",
    "Por arreglarEl puerto UDP 49003 lo usa otro programa.Qué hacer: sudo ss -ulpn",
  ]);
});

test("it is looked at again when that is asked for, once at a time, and in another language", async () => {
  const station = await setup("owner");
  await looks(station)[0]?.answer({ findings: FINDINGS });
  await user.click(within(panel()).getByRole("button", { name: "Mirar otra vez" }));
  await user.click(within(panel()).getByRole("button", { name: /Mirar otra vez/ }));
  expect(looks(station)).toHaveLength(2);
  await looks(station)[1]?.answer({ findings: [] });
  act(() => station.page.settings.setState({ language: "en" }));
  expect(looks(station).map(({ path }) => path.slice(-2))).toEqual(["es", "es", "en"]);
});

test("with a board it waits to be asked", async () => {
  const station = await setup("owner", aStatus());
  expect(looks(station)).toEqual([]);
  await user.click(within(panel()).getByRole("button", { name: "Mirar" }));
  expect(looks(station)).toHaveLength(1);
});

test("a failure is said, what was found before stays, and nothing is tried by itself", async () => {
  const station = await setup("owner");
  await looks(station)[0]?.answer({ findings: FINDINGS });
  await user.click(within(panel()).getByRole("button", { name: "Mirar otra vez" }));
  await looks(station)[1]?.answer({ code: "doctor_late", detail: "x", params: { seconds: 60 } }, 409);
  expect(within(panel()).getByRole("alert").textContent).toContain("más de 60 s");
  expect(within(panel()).getAllByRole("listitem")).toHaveLength(2);
  expect(looks(station)).toHaveLength(2);
});

test("nobody but an owner sees it", async () => {
  const station = await setup("operator");
  expect(screen.queryByRole("region", { name: "El ordenador de la estación" })).toBeNull();
  expect(looks(station)).toEqual([]);
});
