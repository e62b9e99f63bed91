import { screen } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { expect, test, vi } from "vitest";
import { Station } from "../test/station";
import { WORDS } from "../ui/test/testWords";
import { WordsProvider } from "../ui/words";
import { PlaceField } from "./PlaceField";

const user = userEvent.setup();
const gando = { latitude_deg: 27.9319, longitude_deg: -15.3866 };

function open() {
  const onCommit = vi.fn();
  new Station(
    <WordsProvider words={WORDS}>
      <PlaceField place={gando} fixed={undefined} onCommit={onCommit} />
    </WordsProvider>,
  );
  const field = screen.getByLabelText("Coordenadas");
  return { onCommit, field };
}

test("a place typed in degrees, minutes and seconds, or in UTM, is the same place in decimals", async () => {
  const { onCommit, field } = open();
  for (const text of ["28°07'30\"N 15°25'00\"O", "28R 459079.45 3111119.53"]) {
    await user.clear(field);
    await user.type(field, `${text}{Enter}`);
  }
  for (const [place] of onCommit.mock.calls) {
    expect(place.latitude_deg).toBeCloseTo(28.125, 5);
    expect(place.longitude_deg).toBeCloseTo(-15.416667, 5);
  }
  expect(onCommit).toHaveBeenCalledTimes(2);
});

test("what is no place when the field is left is named, until something else is typed", async () => {
  const { onCommit, field } = open();
  await user.clear(field);
  await user.type(field, "27.9 -15.x");
  await user.tab();
  expect(onCommit).not.toHaveBeenCalled();
  expect(field).toHaveProperty("value", "27.931900 -15.386600");
  expect(screen.getByRole("status").textContent).toContain("w-refused 27.9 -15.x: No es un sitio");
  await user.clear(field);
  await user.type(field, "28 -15");
  expect(screen.getByRole("status").textContent).not.toContain("w-refused");
});

test("it is shown as was chosen, and what is no place changes nothing and says so", async () => {
  const { onCommit, field } = open();
  await user.selectOptions(screen.getByLabelText("Notación"), "utm");
  expect(field).toHaveProperty("value", "28R 461964.5 3089718.7");
  await user.clear(field);
  await user.type(field, "Gando{Enter}");
  expect(document.body.textContent).toContain("No es un sitio");
  await user.keyboard("{Escape}");
  expect(field).toHaveProperty("value", "28R 461964.5 3089718.7");
  await user.tab();
  expect(onCommit).not.toHaveBeenCalled();
});
