import { act, fireEvent, screen } from "@testing-library/react";
import { expect, test, vi } from "vitest";
import { Station } from "../test/station";
import { lazyPart } from "../ui/lazyPart";
import { WORDS } from "../ui/test/testWords";
import { WordsProvider } from "../ui/words";
import { LoadFailure } from "./dialogs";

const away = async () => {
  throw new TypeError("Failed to fetch");
};

/** A part in a page whose station answers, and what fetches it, which has failed once. */
async function unfetched() {
  // React logs every failure to the console, even a caught one.
  vi.spyOn(console, "error").mockImplementation(() => undefined);
  const fetched = vi.fn(away);
  const { Part } = lazyPart(fetched);
  const shown = (
    <WordsProvider words={WORDS}>
      <Part waiting="waiting" failed={(retry) => <LoadFailure onRetry={retry} />} />
    </WordsProvider>
  );
  const station = await act(async () => {
    const made = new Station(shown);
    made.greet();
    return made;
  });
  await screen.findByRole("button", { name: "Reintentar" });
  fetched.mockClear();
  return { station, fetched };
}

test("a part that could not be fetched is fetched again by itself once a lost station is back", async () => {
  const { station, fetched } = await unfetched();
  station.breakOff();
  station.pass(300);
  expect(station.wires).toHaveLength(2);
  await act(async () => undefined);
  expect(fetched).not.toHaveBeenCalled();
  await act(async () => station.greet());
  expect(fetched).toHaveBeenCalledTimes(1);
});

test("while the station answers, a part that fails is fetched again at a click alone", async () => {
  const { fetched } = await unfetched();
  await act(async () => fireEvent.click(screen.getByRole("button", { name: "Reintentar" })));
  expect(fetched).toHaveBeenCalledTimes(1);
});
