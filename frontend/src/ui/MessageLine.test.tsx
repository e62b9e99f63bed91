import { render, screen } from "@testing-library/react";
import { expect, test } from "vitest";
import { MessageLine } from "./MessageLine";

test("the newest message is a status, whole also where the line is short", () => {
  const { rerender } = render(<MessageLine label="Message" text="opened" time="12:00:01" />);
  const line = screen.getByRole("status", { name: "Message" });
  expect(line.textContent).toBe("12:00:01opened");
  rerender(<MessageLine label="Message" level="error" text="port taken" />);
  expect(screen.getByRole("status")).toBe(line);
  expect(line.textContent).toBe("port taken");
  expect(line.title).toBe("port taken");
  expect(line.dataset["level"]).toBe("error");
});
