import { cleanup } from "@testing-library/react";
import { afterEach } from "vitest";
import "./effects";

// A worker's files share one document: none begins with what another has left in it.
document.body.replaceChildren();
for (const { name } of [...document.documentElement.attributes]) {
  document.documentElement.removeAttribute(name);
}
localStorage.clear();
sessionStorage.clear();

afterEach(cleanup);
