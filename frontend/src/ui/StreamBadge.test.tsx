import { render } from "@testing-library/react";
import { createRef } from "react";
import { expect, test } from "vitest";
import { StreamBadge, type StreamBadgeHandle } from "./StreamBadge";
import { renderWithWords, WORDS } from "./test/testWords";
import { WordsProvider } from "./words";

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

test("in another language it says the same state at once", () => {
  const ref = createRef<StreamBadgeHandle>();
  const inWords = (stale: string) => (
    <WordsProvider words={{ ...WORDS, stale }}>
      <StreamBadge ref={ref} />
    </WordsProvider>
  );
  const { container, rerender } = render(inWords("viejo"));
  ref.current?.paint("stale", "4.0 s");
  rerender(inWords("old"));
  const badge = container.querySelector<HTMLElement>(".ui-badge");
  expect(badge?.textContent).toBe("old4.0 s");
  expect(badge?.dataset["state"]).toBe("stale");
});
