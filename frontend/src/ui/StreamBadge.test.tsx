import { createRef } from "react";
import { expect, test } from "vitest";
import { StreamBadge, type StreamBadgeHandle } from "./StreamBadge";
import { renderWithWords } from "./test/words";

test("the badge tells state and age in words, from the first moment on", () => {
  const ref = createRef<StreamBadgeHandle>();
  const { container } = renderWithWords(<StreamBadge ref={ref} label="AHRS" />);
  const badge = container.querySelector<HTMLElement>(".ui-badge");
  expect(badge?.textContent).toBe("AHRSw-no-data");
  ref.current?.paint("live", "0.1 s");
  expect(badge?.textContent).toBe("AHRSw-live0.1 s");
  ref.current?.paint("stale", "4.0 s");
  expect(badge?.textContent).toBe("AHRSw-stale4.0 s");
  expect(badge?.dataset["state"]).toBe("stale");
});
