import { screen } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { expect, test } from "vitest";
import { aStatus } from "../../test/aStatus";
import { Station } from "../../test/station";
import { WORDS } from "../../ui/test/testWords";
import { WordsProvider } from "../../ui/words";
import { AhrsTestBanner } from "./AhrsTestBanner";

test("the AHRS test is told over every tab while it runs, and ended from there", async () => {
  const station = new Station(
    <WordsProvider words={WORDS}>
      <AhrsTestBanner />
    </WordsProvider>,
  );
  station.greet();
  expect(screen.queryByText(/Prueba AHRS en marcha/)).toBeNull();
  const status = aStatus();
  station.status({ ...status, board: { ...status.board, ahrs_test: "running" } });
  expect(screen.getByText(/Prueba AHRS en marcha/)).toBeDefined();
  await userEvent.setup().click(screen.getByRole("button", { name: "Terminar la prueba" }));
  expect(station.asked.at(-1)).toMatchObject({ method: "DELETE", path: "/api/v1/ahrs-test" });
});
