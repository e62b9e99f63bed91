import { screen } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { expect, test, vi } from "vitest";
import { Checkbox } from "./Checkbox";
import { RangeField } from "./RangeField";
import { renderWithWords } from "./test/testWords";

test("a box is ticked by keyboard, and tells which way", async () => {
  const onChange = vi.fn();
  renderWithWords(<Checkbox label="Sound" checked={false} onChange={onChange} />);
  const user = userEvent.setup();
  await user.tab();
  await user.keyboard(" ");
  expect(onChange.mock.calls).toEqual([[true]]);
});

test("a box that may not be ticked says why, and does nothing", async () => {
  const onChange = vi.fn();
  renderWithWords(<Checkbox label="Voice" checked={false} onChange={onChange} disabledReason="no voice" />);
  const box = screen.getByRole("checkbox", { name: /Voice/, description: "no voice" });
  await userEvent.setup().click(box);
  expect(onChange).not.toHaveBeenCalled();
  expect(box.getAttribute("aria-disabled")).toBe("true");
});

test("a slider has a name and tells its value in words", () => {
  renderWithWords(
    <RangeField
      label="Volume"
      value={50}
      minimum={0}
      maximum={100}
      step={5}
      text="50 %"
      onChange={vi.fn()}
    />,
  );
  expect(screen.getByRole("slider", { name: "Volume" }).getAttribute("aria-valuetext")).toBe("50 %");
});
