import { oneOf } from "../lib/check";
import { PARAMETERS } from "./messages.gen";

/** A gain that the page's message definition contains. */
export const isParameterName = oneOf(...PARAMETERS.map(({ name }) => name));
