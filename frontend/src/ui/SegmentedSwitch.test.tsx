import { screen } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { afterEach, expect, test, vi } from "vitest";
import { SegmentedSwitch } from "./SegmentedSwitch";
import { renderWithWords } from "./test/testWords";

const OPTIONS = [
  { value: "joystick", label: "Joystick" },
  { value: "rc", label: "RC" },
] as const;

afterEach(() => vi.unstubAllGlobals());

function checked(): string[] {
  return screen
    .getAllByRole<HTMLInputElement>("radio")
    .filter((radio) => radio.checked)
    .map((radio) => radio.value);
}

test("it stands where it is told, not where it was pushed", async () => {
  const onChange = vi.fn();
  renderWithWords(<SegmentedSwitch label="Source" options={OPTIONS} value="rc" onChange={onChange} />);
  await userEvent.click(screen.getByRole("radio", { name: "Joystick" }));
  expect(onChange.mock.calls).toEqual([["joystick"]]);
  expect(checked()).toEqual(["rc"]);
});

test("with the position not known no option is chosen, and either can be asked for", async () => {
  const onChange = vi.fn();
  renderWithWords(<SegmentedSwitch label="Source" options={OPTIONS} value={null} onChange={onChange} />);
  expect(checked()).toEqual([]);
  await userEvent.click(screen.getByRole("radio", { name: "RC" }));
  expect(onChange).toHaveBeenCalledWith("rc");
});

test("the arrow keys ask for the other position", async () => {
  // The simulated keyboard needs this to find the group's radio buttons, and jsdom lacks it.
  vi.stubGlobal("CSS", { escape: (text: string) => text });
  const onChange = vi.fn();
  renderWithWords(<SegmentedSwitch label="Source" options={OPTIONS} value="joystick" onChange={onChange} />);
  await userEvent.tab();
  expect(document.activeElement).toBe(screen.getByRole("radio", { name: "Joystick" }));
  await userEvent.keyboard("{ArrowRight}");
  expect(onChange).toHaveBeenCalledWith("rc");
});

test("the wanted position is marked until it is proven", () => {
  renderWithWords(
    <SegmentedSwitch
      label="Source"
      options={OPTIONS}
      value="rc"
      wanted="joystick"
      state="pending"
      onChange={vi.fn()}
    />,
  );
  const joystick = screen.getByRole("radio", { name: "Joystick" });
  expect(joystick.closest("label")?.dataset["wanted"]).toBe("true");
  expect(screen.getByRole("radio", { name: "RC" }).closest("label")?.dataset["wanted"]).toBe("false");
  expect(screen.getByRole("status").textContent).toBe("w-pending");
});

test("who wants back before the proof has come asks for the old position", async () => {
  vi.stubGlobal("CSS", { escape: (text: string) => text });
  const onChange = vi.fn();
  const { rerender } = renderWithWords(
    <SegmentedSwitch label="Source" options={OPTIONS} value="joystick" onChange={onChange} />,
  );
  const joystick = screen.getByRole("radio", { name: "Joystick" });
  await userEvent.click(joystick);
  expect(onChange).not.toHaveBeenCalled();
  rerender(
    <SegmentedSwitch
      label="Source"
      options={OPTIONS}
      value="joystick"
      wanted="rc"
      state="pending"
      onChange={onChange}
    />,
  );
  await userEvent.click(joystick);
  expect(onChange.mock.calls).toEqual([["joystick"]]);
  screen.getByRole("radio", { name: "RC" }).focus();
  await userEvent.keyboard("{ArrowLeft}");
  expect(onChange.mock.calls).toEqual([["joystick"], ["joystick"]]);
});

test("disabled, it says why and asks for nothing", async () => {
  const onChange = vi.fn();
  renderWithWords(
    <SegmentedSwitch
      label="Source"
      options={OPTIONS}
      value="rc"
      onChange={onChange}
      disabledReason="viewer: no control"
    />,
  );
  expect(screen.getByRole("group", { name: "Source", description: "viewer: no control" })).toBeDefined();
  await userEvent.click(screen.getByRole("radio", { name: "Joystick" }));
  expect(onChange).not.toHaveBeenCalled();
});

test("two switches on a page do not share their positions", () => {
  renderWithWords(
    <>
      <SegmentedSwitch label="One" options={OPTIONS} value="rc" onChange={vi.fn()} />
      <SegmentedSwitch label="Two" options={OPTIONS} value="joystick" onChange={vi.fn()} />
    </>,
  );
  expect(checked()).toEqual(["rc", "joystick"]);
});
