import { fireEvent, screen } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import type { ComponentProps } from "react";
import { expect, test, vi } from "vitest";
import { Button } from "./Button";
import { NumberField } from "./NumberField";
import { EditScope } from "./openEdits";
import { RefusalProvider } from "./refusal";
import { renderWithWords } from "./test/testWords";

function draw(props: Partial<ComponentProps<typeof NumberField>> = {}) {
  const onCommit = vi.fn();
  const field = (more: typeof props) => (
    <NumberField
      label="k_pitch"
      value={2}
      minimum={0}
      maximum={99.99}
      step={0.1}
      onCommit={onCommit}
      {...props}
      {...more}
    />
  );
  const { rerender } = renderWithWords(field({}));
  return {
    onCommit,
    input: screen.getByRole<HTMLInputElement>("textbox", { name: "k_pitch" }),
    again: (more: typeof props) => rerender(field(more)),
  };
}

test("typing sends nothing, Enter sends the finished number once", async () => {
  const { onCommit, input } = draw();
  await userEvent.clear(input);
  await userEvent.type(input, "12,5");
  expect(onCommit).not.toHaveBeenCalled();
  await userEvent.keyboard("{Enter}");
  await userEvent.tab();
  expect(onCommit.mock.calls).toEqual([[12.5]]);
});

test("leaving the field sends the number", async () => {
  const { onCommit, input } = draw();
  await userEvent.clear(input);
  await userEvent.type(input, "3");
  await userEvent.tab();
  expect(onCommit.mock.calls).toEqual([[3]]);
});

test("Escape takes the edit back", async () => {
  const { onCommit, input } = draw();
  await userEvent.type(input, "99");
  await userEvent.keyboard("{Escape}");
  expect(input.value).toBe("2");
  await userEvent.tab();
  expect(onCommit).not.toHaveBeenCalled();
});

test("an edit that changes nothing, and an emptied field, send nothing", async () => {
  const { onCommit, input } = draw();
  await userEvent.clear(input);
  await userEvent.type(input, "2.0{Enter}");
  await userEvent.clear(input);
  await userEvent.tab();
  expect(onCommit).not.toHaveBeenCalled();
  expect(input.value).toBe("2");
});

test("out of range is refused with the range and neither cut nor sent", async () => {
  const { onCommit, input } = draw();
  await userEvent.clear(input);
  await userEvent.type(input, "100{Enter}");
  expect(onCommit).not.toHaveBeenCalled();
  expect(input.getAttribute("aria-invalid")).toBe("true");
  expect(screen.getByRole("status").textContent).toBe("w-outside 0 to 99.99 w-still 2");
  expect(input.value).toBe("100");
});

test("what is no number is refused in words", async () => {
  const { onCommit, input } = draw();
  await userEvent.type(input, "x{Enter}");
  expect(onCommit).not.toHaveBeenCalled();
  expect(screen.getByRole("status").textContent).toBe("w-not-a-number w-still 2");
});

test("a refused edit gives way to the value when the field is left, and the complaint says what it was", async () => {
  const { onCommit, input, again } = draw();
  await userEvent.clear(input);
  await userEvent.type(input, "x{Enter}");
  expect(input.value).toBe("x");
  await userEvent.tab();
  again({ value: 3 });
  expect(input.value).toBe("3");
  expect(input.getAttribute("aria-invalid")).toBeNull();
  expect(screen.getByRole("status").textContent).toBe("w-refused x: w-not-a-number");
  await userEvent.clear(input);
  await userEvent.type(input, "4{Enter}");
  expect(screen.getByRole("status").textContent).toBe("");
  expect(onCommit.mock.calls).toEqual([[4]]);
});

test("what became of an earlier number does not mark an edit, nor one that was refused", async () => {
  const { input } = draw({ state: "confirmed" });
  const mark = () => document.querySelector(".ui-mark:not([data-state=idle])");
  expect(mark()?.getAttribute("data-state")).toBe("confirmed");
  await userEvent.clear(input);
  await userEvent.type(input, "100");
  expect(mark()).toBeNull();
  await userEvent.keyboard("{Enter}");
  expect(mark()).toBeNull();
  await userEvent.tab();
  expect(mark()).toBeNull();
  await userEvent.clear(input);
  await userEvent.keyboard("{Escape}");
  expect(mark()?.getAttribute("data-state")).toBe("confirmed");
});

test("buttons and arrow keys step from the value, and from a draft", async () => {
  const { onCommit, input } = draw();
  await userEvent.click(screen.getByRole("button", { name: "w-increase k_pitch" }));
  await userEvent.click(screen.getByRole("button", { name: "w-decrease k_pitch" }));
  await userEvent.clear(input);
  await userEvent.type(input, "7{ArrowUp}");
  expect(onCommit.mock.calls).toEqual([[2.1], [1.9], [7.1]]);
});

test("the wheel does nothing", () => {
  const { onCommit, input } = draw();
  input.focus();
  fireEvent.wheel(input, { deltaY: -100 });
  expect(onCommit).not.toHaveBeenCalled();
  expect(input.value).toBe("2");
});

test("what was asked for stands there while it is pending, and the board's value afterwards", async () => {
  const { input, again } = draw();
  await userEvent.clear(input);
  await userEvent.type(input, "5{Enter}");
  again({ state: "pending" });
  expect(input.value).toBe("5");
  again({ state: "rejected" });
  expect(input.value).toBe("2");
  expect(screen.getByRole("status").textContent).toBe("w-rejected");
});

test("a value nobody knows is empty, not zero, and the first number typed is sent", async () => {
  const { onCommit, input } = draw({ value: null });
  expect(input.value).toBe("");
  await userEvent.type(input, "0{Enter}");
  expect(onCommit.mock.calls).toEqual([[0]]);
});

test("a value nobody knows cannot be stepped from: that would jump to the end of its range", async () => {
  const { onCommit, input } = draw({ value: null });
  await userEvent.click(screen.getByRole("button", { name: "w-increase k_pitch" }));
  await userEvent.type(input, "{ArrowDown}");
  expect(onCommit).not.toHaveBeenCalled();
  await userEvent.type(input, "7{ArrowUp}");
  expect(onCommit.mock.calls).toEqual([[7.1]]);
});

test("a number in its range that will not do is refused in words", async () => {
  const { onCommit, input } = draw({ refuse: (value) => (Number.isInteger(value) ? null : "w-whole") });
  await userEvent.clear(input);
  await userEvent.type(input, "7.5{Enter}");
  expect(screen.getByRole("status").textContent).toBe("w-whole w-still 2");
  expect(onCommit).not.toHaveBeenCalled();
  await userEvent.clear(input);
  await userEvent.type(input, "7{Enter}");
  expect(onCommit.mock.calls).toEqual([[7]]);
});

test("disabled, it tells why and takes neither text nor steps", async () => {
  const { onCommit, input } = draw({ disabledReason: "no board link" });
  await userEvent.type(input, "5{Enter}{ArrowUp}");
  await userEvent.click(screen.getByRole("button", { name: "w-increase k_pitch" }));
  expect(onCommit).not.toHaveBeenCalled();
  expect(input.value).toBe("2");
  expect(screen.getByRole("textbox", { description: "no board link" })).toBe(input);
});

test("why an edit was refused is also said where answers stand", async () => {
  const refuse = vi.fn();
  renderWithWords(
    <RefusalProvider value={refuse}>
      <NumberField label="k_roll" value={2} minimum={0} maximum={10} step={1} onCommit={vi.fn()} />
    </RefusalProvider>,
  );
  const input = screen.getByRole("textbox", { name: "k_roll" });
  await userEvent.clear(input);
  await userEvent.type(input, "1e9{Enter}");
  expect(refuse).toHaveBeenCalledTimes(1);
  expect(refuse.mock.calls[0]?.[0]).toContain("1e9");
});

function askWhich(props: Partial<ComponentProps<typeof NumberField>> = {}) {
  const drawn = draw({ value: 812, maximum: 60_000, ...props });
  return { ...drawn, question: () => screen.queryByRole("group", { name: "w-which" }) };
}

test.each([
  ["1,000", "1000", 1000],
  ["1.000", "1", 1],
  ["1.500", "1.5", 1.5],
])(
  "%s can be two numbers: the field asks, and the answer %s is what is sent",
  async (text, answer, value) => {
    const { onCommit, input, question } = askWhich();
    await userEvent.clear(input);
    await userEvent.type(input, `${text}{Enter}`);
    expect(onCommit).not.toHaveBeenCalled();
    expect(screen.getByRole("status").textContent).toBe("w-which w-still 812");
    await userEvent.click(screen.getByRole("button", { name: answer }));
    expect(onCommit.mock.calls).toEqual([[value]]);
    expect(question()).toBeNull();
    expect(document.activeElement).toBe(input);
  },
);

test("a field that is left shows its value and goes on asking, by keyboard too", async () => {
  const { onCommit, input } = askWhich({ unit: "ft" });
  await userEvent.clear(input);
  await userEvent.type(input, "1,000");
  await userEvent.tab();
  expect(input.value).toBe("812");
  expect(document.activeElement).toBe(screen.getByRole("button", { name: "1000 ft" }));
  await userEvent.keyboard("{Enter}");
  expect(onCommit.mock.calls).toEqual([[1000]]);
  expect(document.activeElement).toBe(input);
});

test("a step from a number with two readings asks too, and takes none of them", async () => {
  const { onCommit, input, question } = askWhich();
  await userEvent.clear(input);
  await userEvent.type(input, "1,000{ArrowUp}");
  expect(question()).not.toBeNull();
  await userEvent.click(screen.getByRole("button", { name: "w-increase k_pitch" }));
  expect(onCommit).not.toHaveBeenCalled();
  expect(question()).not.toBeNull();
});

test("Escape and another number take the question away", async () => {
  const { onCommit, input, question } = askWhich();
  await userEvent.clear(input);
  await userEvent.type(input, "1,000{Enter}{Escape}");
  expect(question()).toBeNull();
  await userEvent.clear(input);
  await userEvent.type(input, "1,000{Enter}");
  expect(question()).not.toBeNull();
  await userEvent.clear(input);
  await userEvent.type(input, "900{Enter}");
  expect(question()).toBeNull();
  expect(onCommit.mock.calls).toEqual([[900]]);
});

test("what the field itself showed is not asked about", async () => {
  const { onCommit, input, question } = askWhich({ value: 1.25, format: (value) => value.toFixed(3) });
  await userEvent.clear(input);
  await userEvent.type(input, "1.250{Enter}");
  expect(question()).toBeNull();
  expect(onCommit).not.toHaveBeenCalled();
});

test("a field that shows another thing's number does not ask about the first one's", async () => {
  const { input, question, again } = askWhich({ subject: "first" });
  await userEvent.clear(input);
  await userEvent.type(input, "1,000");
  await userEvent.tab();
  expect(question()).not.toBeNull();
  again({ subject: "second" });
  expect(question()).toBeNull();
});

function form() {
  const onPress = vi.fn();
  const refuse = vi.fn();
  renderWithWords(
    <RefusalProvider value={refuse}>
      <EditScope>
        <NumberField label="altitude" value={812} minimum={0} maximum={60_000} step={1} onCommit={vi.fn()} />
        <Button takesFields onPress={onPress}>
          fly
        </Button>
        <Button onPress={onPress}>cancel</Button>
      </EditScope>
    </RefusalProvider>,
  );
  const input = screen.getByRole<HTMLInputElement>("textbox", { name: "altitude" });
  return {
    onPress,
    refuse,
    input,
    press: (name: string) => userEvent.click(screen.getByRole("button", { name })),
  };
}

test.each(["1,000", "100000", "x"])(
  "a form's button does not act on the old value when %s was typed and the button pressed at once",
  async (text) => {
    const { onPress, refuse, input, press } = form();
    await userEvent.clear(input);
    await userEvent.type(input, text);
    await press("fly");
    expect(onPress).not.toHaveBeenCalled();
    expect(refuse).toHaveBeenLastCalledWith("w-open altitude");
    await press("cancel");
    expect(onPress).toHaveBeenCalledTimes(1);
    await userEvent.clear(input);
    await userEvent.type(input, "900");
    await press("fly");
    expect(onPress).toHaveBeenCalledTimes(2);
  },
);
