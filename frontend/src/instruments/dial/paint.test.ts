// @vitest-environment jsdom
import { expect, test } from "vitest";
import { attributeNumber, removeAttribute, setAttribute, setText } from "./paint";

/** Counts how often an element is really written to. */
async function writesTo(element: Element, act: () => void): Promise<number> {
  let writes = 0;
  const observer = new MutationObserver((records) => {
    writes += records.length;
  });
  observer.observe(element, { attributes: true, childList: true, characterData: true, subtree: true });
  act();
  writes += observer.takeRecords().length;
  observer.disconnect();
  return writes;
}

test("an equal attribute or text is not written again", async () => {
  const element = document.createElement("p");
  const writes = await writesTo(element, () => {
    setAttribute(element, "transform", "rotate(1)");
    setAttribute(element, "transform", "rotate(1)");
    setText(element, "12");
    setText(element, "12");
    removeAttribute(element, "title");
  });
  expect(writes).toBe(2);
});

test("painting onto an element that is not there yet does nothing", () => {
  expect(() => {
    setAttribute(null, "transform", "rotate(1)");
    setText(null, "12");
    removeAttribute(null, "title");
  }).not.toThrow();
});

test("no minus stands before a zero", () => {
  expect(attributeNumber(-0.04, 1)).toBe("0.0");
  expect(attributeNumber(-0, 0)).toBe("0");
  expect(attributeNumber(-0.05, 1)).toBe("-0.1");
  expect(attributeNumber(30, 1)).toBe("30.0");
});
