import { act, configure, getConfig } from "@testing-library/react";
import { createRoot } from "react-dom/client";

// What a test waits for can be in the document before its effects have run, on a busy machine: an instrument would miss
// the next sample. React runs every effect that is due before it renders anything, so each wait ends with a render.
// Here and not in the set-up, which runs again for each file of a worker.
const { asyncWrapper } = getConfig();
const nothing = createRoot(document.createElement("div"));

configure({
  // A second of its own would be short on a busy machine. Nothing else needs this long but what never comes.
  asyncUtilTimeout: 120_000,
  asyncWrapper: async (wait) => {
    const found = await asyncWrapper(wait);
    act(() => nothing.render(null));
    return found;
  },
});
