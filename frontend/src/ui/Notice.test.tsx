import { screen } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { expect, test, vi } from "vitest";
import { Notice } from "./Notice";
import { renderWithWords } from "./test/testWords";

test("an error interrupts and can be put away", async () => {
  const onDismiss = vi.fn();
  renderWithWords(
    <Notice level="error" onDismiss={onDismiss}>
      the port does not exist
    </Notice>,
  );
  expect(screen.getByRole("alert").textContent).toBe("the port does not exist");
  await userEvent.click(screen.getByRole("button", { name: "w-dismiss" }));
  expect(onDismiss).toHaveBeenCalledOnce();
});

test.each(["info", "warning"] as const)("an %s waits its turn and has no button of its own", (level) => {
  renderWithWords(<Notice level={level}>text</Notice>);
  expect(screen.getByRole("status").textContent).toBe("text");
  expect(screen.queryByRole("button")).toBeNull();
});
