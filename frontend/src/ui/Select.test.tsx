import { render, screen } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { expect, test, vi } from "vitest";
import { Select } from "./Select";

const PORTS = [
  { value: "/dev/ttyUSB0", label: "ttyUSB0: FT232R" },
  { value: "/dev/ttyACM0", label: "ttyACM0" },
] as const;

test("a choice is told by its value", async () => {
  const onChange = vi.fn();
  render(<Select label="Port" options={PORTS} value={null} placeholder="choose" onChange={onChange} />);
  const select = screen.getByRole<HTMLSelectElement>("combobox", { name: "Port" });
  expect(select.selectedOptions[0]?.textContent).toBe("choose");
  await userEvent.selectOptions(select, "ttyACM0");
  expect(onChange.mock.calls).toEqual([["/dev/ttyACM0"]]);
});

test("it shows the value that it is given, and then no placeholder", () => {
  render(
    <Select label="Port" options={PORTS} value="/dev/ttyUSB0" placeholder="choose" onChange={vi.fn()} />,
  );
  expect(screen.getByRole<HTMLSelectElement>("combobox").selectedOptions[0]?.textContent).toBe(
    "ttyUSB0: FT232R",
  );
  expect(screen.queryByText("choose")).toBeNull();
});

test("disabled, it tells why", () => {
  render(
    <Select
      label="Port"
      options={PORTS}
      value={null}
      placeholder="choose"
      onChange={vi.fn()}
      disabledReason="the link is open"
    />,
  );
  const select = screen.getByRole<HTMLSelectElement>("combobox", {
    name: "Port",
    description: "the link is open",
  });
  expect(select.getAttribute("aria-disabled")).toBe("true");
});
