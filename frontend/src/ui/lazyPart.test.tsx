import { act, cleanup, render, screen } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { expect, test, vi } from "vitest";
import { lazyPart } from "./lazyPart";

const Arrived = () => <p>arrived</p>;

function failed(retry: () => void) {
  return (
    <button type="button" onClick={retry}>
      again
    </button>
  );
}

test("what was loaded before is there at the first look", async () => {
  const { Part, load } = lazyPart(async () => Arrived);
  await load();
  render(<Part waiting="waiting" failed={failed} />);
  expect(screen.getByText("arrived")).toBeTruthy();
});

test("what is being loaded says so, and is loaded once however often it is shown", async () => {
  let arrive = (): void => undefined;
  const source = vi.fn(
    () =>
      new Promise<typeof Arrived>((resolve) => {
        arrive = () => resolve(Arrived);
      }),
  );
  const { Part } = lazyPart(source);
  await act(async () => {
    render(<Part waiting="waiting" failed={failed} />);
  });
  expect(screen.getByText("waiting")).toBeTruthy();
  await act(async () => arrive());
  expect(screen.getByText("arrived")).toBeTruthy();
  cleanup();
  render(<Part waiting="waiting" failed={failed} />);
  expect(screen.getByText("arrived")).toBeTruthy();
  expect(source).toHaveBeenCalledTimes(1);
});

test("what could not be loaded can be asked for again", async () => {
  // React logs every failure to the console, even a caught one.
  vi.spyOn(console, "error").mockImplementation(() => undefined);
  let isThere = false;
  const { Part } = lazyPart(async () => {
    if (!isThere) {
      throw new TypeError("Failed to fetch");
    }
    return Arrived;
  });
  await act(async () => {
    render(<Part waiting="waiting" failed={failed} />);
  });
  isThere = true;
  await act(async () => {
    await userEvent.setup().click(screen.getByRole("button", { name: "again" }));
  });
  expect(screen.getByText("arrived")).toBeTruthy();
});

test("a failure before it was needed is forgotten", async () => {
  let isThere = false;
  const { Part, load } = lazyPart(async () => {
    if (!isThere) {
      throw new TypeError("Failed to fetch");
    }
    return Arrived;
  });
  await load();
  isThere = true;
  await act(async () => {
    render(<Part waiting="waiting" failed={failed} />);
  });
  expect(screen.getByText("arrived")).toBeTruthy();
});
