/**
 * What is wrong with the layout of what is on top now (a menu, a dialog or the window), measured in the page: text that is
 * cut without a way to read it, controls outside of the window or covered that no scrolling brings out, anything that
 * scrolls sideways or beyond the end of the page, and targets smaller than `target_px`. Runs in the page: it must not use
 * anything from outside.
 */
export function layoutFaults(target_px: number): string[] {
  const SLACK_PX = 1.5;
  const LINE_SLACK_PX = 4;
  const CONTROLS = [
    ...["button", "a[href]", "input", "select", "textarea", "summary", "[role=tab]", "[role=slider]", "[role=switch]"],
    ...["[role=menuitem]", "[role=menuitemradio]", "[role=menuitemcheckbox]", "[role=option]"],
  ].join(",");
  const found = new Set<string>();

  function isShown(element: Element): boolean {
    if (!element.checkVisibility({ visibilityProperty: true })) return false;
    for (let each: Element | null = element; each !== null; each = each.parentElement) {
      if (getComputedStyle(each).clipPath === "inset(50%)" || each.hasAttribute("data-base-ui-focus-guard"))
        return false;
    }
    return true;
  }
  function nameOf(element: Element): string {
    const words = element.getAttribute("aria-label") ?? element.textContent ?? "";
    const kind = typeof element.className === "string" ? element.className.split(" ")[0] : "";
    return `${element.tagName.toLowerCase()}.${kind} "${words.trim().replaceAll(/\s+/g, " ").slice(0, 40)}"`;
  }
  function scrolls(overflow: string): boolean {
    return overflow === "auto" || overflow === "scroll";
  }
  function saysRest(element: Element, edge: CSSStyleDeclaration): boolean {
    const isMarked = edge.textOverflow === "ellipsis" || edge.webkitLineClamp !== "none";
    return isMarked && element.closest("[title]") !== null;
  }

  /** Whether an ancestor cuts the text off where no scrolling reaches it. */
  function checkText(text: Text, top: Element): void {
    const holder = text.parentElement;
    if (holder === null || holder.closest("svg, option, [role=application], [role=img]") !== null || !isShown(holder))
      return;
    const range = document.createRange();
    range.selectNodeContents(text);
    const box = range.getBoundingClientRect();
    if (box.width < 1) return;
    let [isOpenX, isOpenY] = [true, true];
    for (let each: Element | null = holder; each !== null; each = each.parentElement) {
      const style = getComputedStyle(each);
      const edge = each.getBoundingClientRect();
      const isInline = style.display === "inline" || style.display === "contents";
      if (!isInline) {
        if (scrolls(style.overflowX)) isOpenX = false;
        if (scrolls(style.overflowY)) isOpenY = false;
        const cutsX =
          isOpenX &&
          style.overflowX !== "visible" &&
          (box.left < edge.left - SLACK_PX || box.right > edge.right + SLACK_PX);
        const cutsY =
          isOpenY &&
          style.overflowY !== "visible" &&
          (box.top < edge.top - LINE_SLACK_PX || box.bottom > edge.bottom + LINE_SLACK_PX);
        if ((cutsX || cutsY) && !saysRest(each, style)) {
          found.add(`cut text${cutsY ? " (below)" : ""}: "${text.data.trim().slice(0, 30)}" by ${nameOf(each)}`);
          return;
        }
        if (cutsX || cutsY) return;
      }
      if (style.position === "fixed" || each === top) break;
    }
    if (isOpenX && (box.left < -SLACK_PX || box.right > innerWidth + SLACK_PX)) {
      found.add(`text outside: "${text.data.trim().slice(0, 30)}" in ${nameOf(holder)}`);
    }
  }

  /** What a finger or pointer meets: the label, where the input itself is not drawn. */
  function targetOf(control: Element): Element | null {
    if (!(control instanceof HTMLInputElement)) return control;
    const label = control.closest("label") ?? control.labels?.[0] ?? null;
    const isDrawn = isShown(control) && control.getBoundingClientRect().width > 2;
    return control.type === "radio" || control.type === "checkbox" || !isDrawn ? label : control;
  }
  function checkControl(control: Element): void {
    const target = targetOf(control);
    if (target === null || !isShown(target)) return;
    if (control instanceof HTMLInputElement && control.type === "file") return;
    const style = getComputedStyle(target);
    if (style.pointerEvents === "none") return;
    target.scrollIntoView({ block: "nearest", inline: "nearest", behavior: "instant" });
    const box = target.getBoundingClientRect();
    if (box.width === 0 || box.height === 0) return;
    const isIn =
      box.left >= -SLACK_PX &&
      box.right <= innerWidth + SLACK_PX &&
      (box.height > innerHeight || (box.top >= -SLACK_PX && box.bottom <= innerHeight + SLACK_PX));
    if (!isIn) {
      found.add(
        `outside the window: ${nameOf(target)} at ${[box.left, box.top, box.right, box.bottom].map(Math.round)}`,
      );
      return;
    }
    const [x, y] = [box.left + box.width / 2, Math.min(innerHeight - 1, box.top + box.height / 2)];
    const hit = document.elementFromPoint(x, y);
    if (
      hit !== null &&
      hit !== target &&
      !target.contains(hit) &&
      !control.contains(hit) &&
      !hit.closest("label")?.contains(control) &&
      !isUnderAlarm(hit)
    ) {
      found.add(`covered: ${nameOf(target)} by ${nameOf(hit)}`);
    }
    const isInText = target.tagName === "A" && style.display === "inline";
    if (!isInText && (box.width < target_px - 0.5 || box.height < target_px - 0.5)) {
      found.add(`small: ${nameOf(target)} ${box.width.toFixed(0)}×${box.height.toFixed(0)}`);
    }
  }

  /** An alarm lies over the page until somebody acknowledges it, so that nothing moves when it comes. */
  function isUnderAlarm(hit: Element): boolean {
    return hit.closest(".ui-alarms")?.querySelector('.ui-alarm[data-acknowledged="false"]') != null;
  }

  function checkSideways(element: Element): void {
    if (element.scrollWidth <= element.clientWidth + 1 || element.clientWidth === 0) return;
    const isTable =
      element.tagName === "TABLE" ||
      element.querySelector(":scope > table, :scope > [role=table], :scope > [role=grid]") !== null;
    // Rows that keep their height: of tabs, and of alarms that have ended, however many there are.
    const isRow = element.matches("[role=tablist], .ui-alarms-chips");
    if (isTable || isRow || !isShown(element)) return;
    if (element instanceof HTMLInputElement) {
      if (element.inputMode === "decimal") found.add(`cut number: ${nameOf(element)} "${element.value}"`);
    } else if (scrolls(getComputedStyle(element).overflowX)) {
      found.add(`scrolls sideways: ${nameOf(element)} ${element.scrollWidth} in ${element.clientWidth}`);
    }
  }

  const over = [...document.querySelectorAll("[role=menu], [role=dialog], [role=alertdialog]")].filter(isShown);
  const top = over.at(-1) ?? document.body;
  if (document.documentElement.scrollWidth > innerWidth + 1) {
    found.add(`the page scrolls sideways: ${document.documentElement.scrollWidth} in ${innerWidth}`);
  }
  const end = (document.querySelector("#root > *")?.getBoundingClientRect().bottom ?? 0) + scrollY;
  if (document.documentElement.scrollHeight > Math.max(innerHeight, end) + SLACK_PX) {
    found.add(`the page scrolls into emptiness: ${document.documentElement.scrollHeight} in ${innerHeight}`);
  }
  const texts = document.createTreeWalker(top, NodeFilter.SHOW_TEXT);
  for (let text = texts.nextNode(); text !== null; text = texts.nextNode()) {
    if (text instanceof Text && text.data.trim() !== "") checkText(text, document.documentElement);
  }
  for (const element of [top, ...top.querySelectorAll("*")]) checkSideways(element);
  for (const control of top.querySelectorAll(CONTROLS)) checkControl(control);
  return [...found];
}
