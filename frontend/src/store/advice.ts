import { type Message, type MessageParams, wordsOf } from "./messages";

/** What advice says, apart from its code. */
export interface AdviceMessage {
  readonly level: unknown;
  /** The gateway's own words, for a code that the page does not know. */
  readonly text: unknown;
  readonly params: unknown;
}

/** Advice in the page's language by its code. */
export function adviceMessage(code: string, { level, text, params }: AdviceMessage): Message {
  const words: MessageParams = wordsOf(typeof params === "object" && params !== null ? { ...params } : {});
  return {
    level: level === "warning" ? "warning" : "info",
    key: `advice.${code}`,
    params: {
      ...words,
      ...("name" in words ? { name: `@simulatorRow.${words["name"]}` } : {}),
      ...("direction" in words ? { direction: `@direction.${words["direction"]}` } : {}),
    },
    fallback: typeof text === "string" ? text : code,
  };
}
