import { render } from "@testing-library/react";
import type { ReactElement } from "react";
import { RefusalProvider } from "../refusal";
import { type Words, WordsProvider } from "../words";

/** Words of a made-up language: a test that finds one of them knows that it came from the catalogue. */
export const WORDS: Words = {
  live: "w-live",
  stale: "w-stale",
  noData: "w-no-data",
  pending: "w-pending",
  confirmed: "w-confirmed",
  rejected: "w-rejected",
  timedOut: "w-timed-out",
  sent: "w-sent",
  on: "w-on",
  off: "w-off",
  unknown: "w-unknown",
  increase: "w-increase",
  decrease: "w-decrease",
  dismiss: "w-dismiss",
  close: "w-close",
  warning: "w-warning",
  critical: "w-critical",
  notANumber: "w-not-a-number",
  whichNumber: "w-which",
  outOfRange: (minimum, maximum) => `w-outside ${minimum} to ${maximum}`,
  stillIs: (value) => `w-still ${value}`,
  refusedEdit: (text, why) => `w-refused ${text}: ${why}`,
  openEdit: (label) => `w-open ${label}`,
};

/**
 * Render a control with words around it; `rerender` keeps them. `refused` collects the reasons that answer presses on
 * greyed controls.
 */
export function renderWithWords(control: ReactElement) {
  const refused: string[] = [];
  const drawn = render(control, {
    wrapper: ({ children }) => (
      <WordsProvider words={WORDS}>
        <RefusalProvider value={(reason) => void refused.push(reason)}>{children}</RefusalProvider>
      </WordsProvider>
    ),
  });
  return { ...drawn, refused };
}
