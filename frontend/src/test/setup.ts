import { cleanup } from "@testing-library/react";
import { afterEach, beforeAll } from "vitest";
import { loadViews } from "../app/views";

// Tests look at what is shown, not at how it was fetched.
beforeAll(loadViews);
afterEach(cleanup);
