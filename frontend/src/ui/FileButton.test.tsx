import { screen } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { expect, test, vi } from "vitest";
import { FileButton } from "./FileButton";
import { renderWithWords } from "./test/testWords";

function draw(disabledReason?: string) {
  const onFile = vi.fn();
  const { container } = renderWithWords(
    <FileButton accept=".json" onFile={onFile} disabledReason={disabledReason}>
      Load
    </FileButton>,
  );
  const input = container.querySelector("input");
  if (input === null) {
    throw new Error("there is no field for a file");
  }
  return { onFile, input };
}

test("hands over the chosen file, and the same one again", async () => {
  const { onFile, input } = draw();
  const file = new File(["{}"], "a.json", { type: "application/json" });
  await userEvent.upload(input, file);
  await userEvent.upload(input, file);
  expect(onFile.mock.calls).toEqual([[file], [file]]);
});

test("its button opens the choice, and a disabled one does not", async () => {
  const { input } = draw();
  const opened = vi.spyOn(input, "click");
  await userEvent.click(screen.getByRole("button", { name: "Load" }));
  expect(opened).toHaveBeenCalledTimes(1);
});

test("disabled, it says why and opens nothing", async () => {
  const { input } = draw("no board link");
  const opened = vi.spyOn(input, "click");
  await userEvent.click(screen.getByRole("button", { name: "Load", description: "no board link" }));
  expect(opened).not.toHaveBeenCalled();
});
