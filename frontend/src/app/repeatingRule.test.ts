import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import ts from "typescript";
import { expect, test } from "vitest";

const source = join(import.meta.dirname, "..");
const OWNER = "lib/repeating.ts";
const TIMERS = new Set(["after", "setTimeout"]);

type Named = ts.FunctionLikeDeclaration & { readonly body: ts.Node };

/** A file's functions by their name, also those that a constant or a field holds. */
function functionsOf(file: ts.SourceFile): Map<string, ts.Node> {
  const found = new Map<string, ts.Node>();
  const visit = (node: ts.Node): void => {
    const isHolder = ts.isVariableDeclaration(node) || ts.isPropertyDeclaration(node);
    const made = isHolder ? node.initializer : node;
    if (made !== undefined && ts.isFunctionLike(made) && "name" in node && node.name !== undefined) {
      const { body } = made as Named;
      if (body !== undefined) {
        found.set((node.name as ts.Node).getText(file), body);
      }
    }
    node.forEachChild(visit);
  };
  visit(file);
  return found;
}

/** The names of the file's functions that this piece of code mentions. */
function mentions(piece: ts.Node, functions: ReadonlyMap<string, ts.Node>): Set<string> {
  const found = new Set<string>();
  const visit = (node: ts.Node): void => {
    if ((ts.isIdentifier(node) || ts.isPrivateIdentifier(node)) && functions.has(node.text)) {
      found.add(node.text);
    }
    node.forEachChild(visit);
  };
  visit(piece);
  return found;
}

/** Whether this piece of code arms a timer. */
function armsTimer(node: ts.Node): node is ts.CallExpression {
  if (!ts.isCallExpression(node)) {
    return false;
  }
  const { expression } = node;
  const called = ts.isPropertyAccessExpression(expression) ? expression.name : expression;
  return ts.isIdentifier(called) && TIMERS.has(called.text);
}

/** What the callbacks of the timers that this piece of code arms mention. */
function armed(piece: ts.Node, functions: ReadonlyMap<string, ts.Node>): string[] {
  const inner: string[] = [];
  piece.forEachChild((node) => {
    inner.push(...armed(node, functions));
  });
  const own = armsTimer(piece)
    ? piece.arguments.flatMap((argument) => [...mentions(argument, functions)])
    : [];
  return [...own, ...inner];
}

/** The functions that a timer's callback reaches, and that arm that timer. */
function chains(text: string): string[] {
  const file = ts.createSourceFile("file.tsx", text, ts.ScriptTarget.Latest, true, ts.ScriptKind.TSX);
  const functions = functionsOf(file);
  return [...functions].flatMap(([name, body]) => {
    const seen = new Set<string>();
    const next = armed(body, functions);
    for (let reached = next.pop(); reached !== undefined; reached = next.pop()) {
      const inside = functions.get(reached);
      if (!seen.has(reached) && inside !== undefined) {
        seen.add(reached);
        next.push(...mentions(inside, functions));
      }
    }
    return seen.has(name) ? [name] : [];
  });
}

test("a timer that arms itself again is found, directly and by another function; a single one is none", () => {
  expect(chains("function step() { timers.after(20, step); }")).toEqual(["step"]);
  expect(
    chains("class A { #look() { this.t.after(5, () => this.#next()); } #next() { this.#look(); } }"),
  ).toEqual(["#look"]);
  expect(chains("const again = async () => { setTimeout(() => void again(), 5); };")).toEqual(["again"]);
  expect(chains("function once() { timers.after(20, () => tell()); } function tell() {}")).toEqual([]);
});

test("only Repeating arms a timer from its own callback", () => {
  const files = readdirSync(source, { recursive: true, encoding: "utf8" }).filter(
    (name) => /\.tsx?$/.test(name) && !/\.(test|gen|d)\.tsx?$/.test(name) && !name.startsWith("test/"),
  );
  const found = files.flatMap((name) =>
    chains(readFileSync(join(source, name), "utf8")).map((chain) => `${name}: ${chain}`),
  );
  expect(files.length).toBeGreaterThan(400);
  expect(found.filter((chain) => !chain.startsWith(OWNER))).toEqual([]);
});
