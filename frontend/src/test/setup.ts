import { cleanup } from "@testing-library/react";
import { afterAll, afterEach, vi } from "vitest";
import "./effects";

// A worker's files share one document: none begins with what another has left in it.
document.body.replaceChildren();
for (const { name } of [...document.documentElement.attributes]) {
  document.documentElement.removeAttribute(name);
}
localStorage.clear();
sessionStorage.clear();

afterEach(cleanup);

// A part that is still being loaded when its file ends would fail the file that comes after it.
afterAll(() => vi.dynamicImportSettled());
