import { Fragment, type ReactNode, useRef, useState } from "react";
import { useTranslation } from "react-i18next";
import { useSettings } from "../../store/hooks";
import type { Language } from "../../store/settings";
import english from "./en.md?raw";
import spanish from "./es.md?raw";
import "./guide.css";
import { type Block, type Inline, readChapters } from "./markdown";
import { RoleTable } from "./RoleTable";

const CHAPTERS = { es: readChapters(spanish), en: readChapters(english) };

/** The guide for pilots: chapters on the left, the open one beside them. All of it is part of the page. */
export function GuideContent() {
  const { t } = useTranslation();
  const language = useSettings((settings) => settings.language);
  const [number, setNumber] = useState(0);
  const page = useRef<HTMLElement>(null);
  const chapters = CHAPTERS[language];
  const chapter = chapters[number];
  function turnTo(next: number): void {
    setNumber(next);
    if (page.current !== null) {
      page.current.scrollTop = 0;
    }
  }
  return (
    <div className="guide">
      <nav aria-label={t("guide.chapters")}>
        <ol className="guide-chapters">
          {chapters.map(({ title }, index) => (
            <li key={title}>
              <button
                type="button"
                aria-current={index === number ? "page" : undefined}
                onClick={() => turnTo(index)}
              >
                {title}
              </button>
            </li>
          ))}
        </ol>
      </nav>
      {chapter !== undefined && (
        // biome-ignore lint/a11y/noNoninteractiveTabindex: what scrolls must be in reach of the keyboard
        <article ref={page} className="guide-page" aria-label={chapter.title} tabIndex={0}>
          <h3>{chapter.title}</h3>
          {chapter.blocks.map((block, index) => (
            // biome-ignore lint/suspicious/noArrayIndexKey: the text of a chapter does not change
            <Fragment key={index}>{draw(block, language)}</Fragment>
          ))}
        </article>
      )}
    </div>
  );
}

function draw(block: Block, language: Language): ReactNode {
  switch (block.kind) {
    case "heading":
      return <h4>{block.text}</h4>;
    case "paragraph":
      return <p>{words(block.text)}</p>;
    case "list":
      return <ul>{items(block.items)}</ul>;
    case "steps":
      return <ol>{items(block.items)}</ol>;
    case "picture":
      return (
        <figure>
          <img src={`/guide/${language}/${block.name}.webp`} alt={block.text} width={1366} height={768} />
          <figcaption>{block.text}</figcaption>
        </figure>
      );
    case "roles":
      return <RoleTable />;
    case "table":
      return <Table head={block.head} rows={block.rows} />;
  }
}

function Table({ head, rows }: { head: readonly string[]; rows: readonly (readonly Inline[])[][] }) {
  return (
    <table>
      <thead>
        <tr>
          {head.map((cell) => (
            <th key={cell} scope="col">
              {cell}
            </th>
          ))}
        </tr>
      </thead>
      <tbody>
        {rows.map((row) => (
          <tr key={plain(row[0] ?? [])}>
            {row.map((cell) => (
              <td key={plain(cell)}>{words(cell)}</td>
            ))}
          </tr>
        ))}
      </tbody>
    </table>
  );
}

function items(list: readonly (readonly Inline[])[]): ReactNode {
  return list.map((item) => <li key={plain(item)}>{words(item)}</li>);
}

function plain(text: readonly Inline[]): string {
  return text.map((piece) => piece.text).join("");
}

function words(text: readonly Inline[]): ReactNode {
  return text.map(({ kind, text: piece }, index) => {
    const key = `${index} ${piece}`;
    if (kind === "strong") {
      return <strong key={key}>{piece}</strong>;
    }
    return kind === "code" ? <code key={key}>{piece}</code> : <Fragment key={key}>{piece}</Fragment>;
  });
}
