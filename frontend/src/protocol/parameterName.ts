import { oneOf } from "../lib/check";
import { PARAMETERS } from "./messages.gen";

/** A gain that this page's definition of the wire has. */
export const isParameterName = oneOf(...PARAMETERS.map(({ name }) => name));
