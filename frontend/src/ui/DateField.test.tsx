import { render, screen } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { useState } from "react";
import { expect, test, vi } from "vitest";
import { DateField, isDay } from "./DateField";

const onChange = vi.fn();

function Bench() {
  const [day, setDay] = useState("");
  return (
    <DateField
      label="From"
      form="YYYY-MM-DD"
      value={day}
      onChange={(next) => {
        onChange(next);
        setDay(next);
      }}
    />
  );
}

function field(): HTMLInputElement {
  return screen.getByRole<HTMLInputElement>("textbox", { name: "From" });
}

test("a day is typed year first, and is taken when it is whole", async () => {
  onChange.mockClear();
  render(<Bench />);
  expect(field().placeholder).toBe("YYYY-MM-DD");
  await userEvent.type(field(), "2026-01-31");
  expect(onChange.mock.calls).toEqual([["2026-01-31"]]);
  await userEvent.clear(field());
  expect(onChange.mock.calls.at(-1)).toEqual([""]);
});

test("what is no day stays in its field with the form of one, and asks for nothing", async () => {
  onChange.mockClear();
  render(<Bench />);
  await userEvent.type(field(), "31/01/2026{Enter}");
  expect(field().value).toBe("31/01/2026");
  expect(field().getAttribute("aria-invalid")).toBe("true");
  expect(screen.getByText("YYYY-MM-DD")).toBeDefined();
  expect(onChange).not.toHaveBeenCalled();
  await userEvent.clear(field());
  await userEvent.type(field(), "2026-01-31");
  expect(field().getAttribute("aria-invalid")).toBeNull();
  expect(onChange.mock.calls).toEqual([["2026-01-31"]]);
});

test.each(["2026-02-30", "2026-13-01", "26-01-01", ""])("%s is no day", (text) => {
  expect(isDay(text)).toBe(false);
});
