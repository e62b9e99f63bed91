import "./theme/fonts.css";
import "./theme/tokens.css";
import "./theme/base.css";
import { StrictMode } from "react";
import { createRoot } from "react-dom/client";
import { I18nextProvider } from "react-i18next";
import { App } from "./app/App";
import { browserWorld } from "./app/browser";
import { CATALOGUES } from "./app/catalogues";
import { loadParts } from "./app/dialogs";
import { createPage } from "./app/page";
import { createI18n } from "./i18n/i18n";
import { PageContext } from "./store/hooks";
import { applyTheme } from "./theme/theme";

const root = document.getElementById("root");
if (root === null) {
  throw new Error("index.html has no element #root");
}
const { page, start } = createPage(browserWorld(window));
// Before the first paint, so that the page does not flash in another theme.
applyTheme(document.documentElement, page.settings.getState().theme);
createRoot(root).render(
  <StrictMode>
    <I18nextProvider i18n={createI18n(CATALOGUES, page.settings.getState().language)}>
      <PageContext value={page}>
        <App />
      </PageContext>
    </I18nextProvider>
  </StrictMode>,
);
start();
// After the page is shown. Preload the globe's engine, when nothing else is loading, for users who have opened it
// before.
setTimeout(() => {
  void loadParts().then(() => {
    const { choices } = page.settings.getState();
    if (choices["map.opened"] === "yes" && choices["map.kind"] !== "2d") {
      (window.requestIdleCallback ?? setTimeout)(
        () => void import("./scene/globe/keptGlobe").catch(() => undefined),
      );
    }
  });
}, 1000);
