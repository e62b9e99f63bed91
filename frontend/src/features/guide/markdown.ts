/** The subset of Markdown that the guide uses, as blocks to draw. */
export type Inline = { readonly kind: "text" | "strong" | "code"; readonly text: string };

export type Block =
  | { readonly kind: "heading"; readonly text: string }
  | { readonly kind: "paragraph"; readonly text: readonly Inline[] }
  | { readonly kind: "list" | "steps"; readonly items: readonly (readonly Inline[])[] }
  | {
      readonly kind: "table";
      readonly head: readonly string[];
      readonly rows: readonly (readonly Inline[])[][];
    }
  /** The generated table of roles. */
  | { readonly kind: "roles" }
  | { readonly kind: "picture"; readonly name: string; readonly text: string };

export interface Chapter {
  readonly title: string;
  readonly blocks: readonly Block[];
}

/** Text -> chapters, each begun by a line with two number signs. Blocks are parted by empty lines. */
export function readChapters(markdown: string): readonly Chapter[] {
  return markdown
    .split(/^## /m)
    .slice(1)
    .map((chapter) => {
      const [title = "", ...rest] = chapter.split("\n");
      const parts = rest.join("\n").split(/\n{2,}/);
      return {
        title,
        blocks: parts
          .map((part) => part.trim())
          .filter((part) => part !== "")
          .map(readBlock),
      };
    });
}

function readBlock(part: string): Block {
  const lines = part.split("\n");
  const picture = /^!\[(.+)\]\(([a-z-]+)\)$/.exec(part);
  if (picture !== null) {
    return { kind: "picture", text: picture[1] ?? "", name: picture[2] ?? "" };
  }
  if (part === "{{roles}}") {
    return { kind: "roles" };
  }
  if (part.startsWith("### ")) {
    return { kind: "heading", text: part.slice(4) };
  }
  if (lines.every((line) => line.startsWith("- "))) {
    return { kind: "list", items: lines.map((line) => readInline(line.slice(2))) };
  }
  if (lines.every((line) => /^\d+\. /.test(line))) {
    return { kind: "steps", items: lines.map((line) => readInline(line.replace(/^\d+\. /, ""))) };
  }
  if (lines.every((line) => line.startsWith("|"))) {
    const [head = [], , ...rows] = lines.map(cells);
    return { kind: "table", head, rows: rows.map((row) => row.map(readInline)) };
  }
  return { kind: "paragraph", text: readInline(part) };
}

function cells(line: string): string[] {
  return line
    .split("|")
    .slice(1, -1)
    .map((cell) => cell.trim());
}

/** Strong words between pairs of asterisks, code between backquotes. */
export function readInline(text: string): readonly Inline[] {
  return text
    .split(/(\*\*.+?\*\*|`.+?`)/)
    .filter((piece) => piece !== "")
    .map((piece) => {
      if (piece.startsWith("**")) {
        return { kind: "strong", text: piece.slice(2, -2) };
      }
      return piece.startsWith("`")
        ? { kind: "code", text: piece.slice(1, -1) }
        : { kind: "text", text: piece };
    });
}
