import { useState } from "react";
import { useTranslation } from "react-i18next";
import { useSentence } from "../../i18n/useSentence";
import { formatMoment } from "../../lib/moment";
import { useBoardBlocked } from "../../requests/useBlocked";
import { usePart } from "../../store/hooks";
import type { Message } from "../../store/messages";
import { Button } from "../../ui/Button";
import { Dialog } from "../../ui/Dialog";
import { Notice } from "../../ui/Notice";
import { type DiffLine, DiffTable } from "./DiffTable";
import type { FileLine, ParameterFile } from "./parameterFile";
import type { Changes, GainInfo } from "./parameterValues";
import { PARAMETER_REQUESTS, stateOf, useParameters } from "./parameterValues";

/** What several gains shall become: their defaults, or what a file says. */
export type Diff =
  | { readonly kind: "reset"; readonly gains: readonly GainInfo[] }
  | { readonly kind: "file"; readonly name: string; readonly file: ParameterFile };

/** Shows what would change, line by line, and writes the ticked lines in one step; then what became of each. */
export function DiffDialog({ diff, onClose }: { diff: Diff; onClose: () => void }) {
  const { t } = useTranslation();
  const parameters = usePart(PARAMETER_REQUESTS);
  const values = useParameters((all) => all);
  const blocked = useBoardBlocked();
  const sentence = useSentence();
  const [lines] = useState(() => linesOf(diff));
  const differing = lines.filter(
    ({ name, wanted }) => name !== null && wanted !== stateOf(values, name).value,
  );
  // A reset was asked for by name; of a file's lines each is chosen by the person.
  const [ticked, setTicked] = useState<ReadonlySet<string>>(
    () => new Set(diff.kind === "reset" ? namesOf(differing) : []),
  );
  const [written, setWritten] = useState<ReadonlySet<string> | null>(null);
  const [isWriting, setWriting] = useState(false);
  const [failure, setFailure] = useState<Message | null>(null);

  async function write(): Promise<void> {
    const changes: Partial<Record<string, number>> = {};
    for (const { name, wanted } of lines) {
      if (name !== null && wanted !== null && ticked.has(name)) {
        changes[name] = wanted;
      }
    }
    setWritten(ticked);
    setWriting(true);
    setFailure(await parameters.write(changes satisfies Changes, { control: "parameters.diff" }));
    setWriting(false);
  }

  const isOver = written !== null && !isWriting;
  const nothing = ticked.size === 0 ? t("paramDiff.nothing") : undefined;
  const all = namesOf(differing);
  return (
    <Dialog
      onClose={() => !isWriting && onClose()}
      title={titleOf()}
      description={t("paramDiff.about")}
      size="wide"
      actions={
        isOver ? (
          <Button variant="primary" onPress={onClose}>
            {t("paramDiff.close")}
          </Button>
        ) : (
          <>
            <Button onPress={() => setTicked(new Set(ticked.size < all.length ? all : []))}>
              {t(ticked.size < all.length ? "paramDiff.tickAll" : "paramDiff.tickNone")}
            </Button>
            <Button onPress={onClose}>{t("paramDiff.cancel")}</Button>
            <Button
              variant="primary"
              onPress={() => void write()}
              state={isWriting ? "pending" : "idle"}
              disabledReason={blocked ?? nothing}
            >
              {t("paramDiff.writeCount", { count: ticked.size })}
            </Button>
          </>
        )
      }
    >
      <div className="params-diff">
        {diff.kind === "file" && <FileNotes file={diff.file} />}
        {failure !== null && <Notice level="error">{sentence(failure)}</Notice>}
        <DiffTable
          lines={lines}
          ticked={ticked}
          written={written}
          isWriting={isWriting}
          onTick={(name, isTicked) => {
            const next = new Set(ticked);
            if (isTicked) next.add(name);
            else next.delete(name);
            setTicked(next);
          }}
        />
      </div>
    </Dialog>
  );

  function titleOf(): string {
    if (diff.kind === "file") {
      return t("paramFile.title", { file: diff.name });
    }
    const [only] = diff.gains;
    return diff.gains.length === 1 && only !== undefined
      ? t("params.resetOne", { name: only.name })
      : t("paramDiff.resetAll");
  }
}

/** A file of another autopilot has a thousand parameters. */
const MOST_NAMES = 12;

function FileNotes({ file }: { file: ParameterFile }) {
  const { t } = useTranslation();
  const { saved, board, missing, leftOut } = file;
  const at_ms = saved === null ? Number.NaN : Date.parse(saved);
  const name = [board?.name, board?.version].filter(Boolean).join(" ");
  return (
    <>
      {Number.isFinite(at_ms) && (
        <p>
          {t("paramFile.savedAt", {
            time: formatMoment(at_ms / 1000, Date.now() / 1000),
            board: name === "" ? t("paramFile.unknownBoard") : name,
          })}
        </p>
      )}
      {leftOut.length > 0 && (
        <Notice level="warning">
          {t("paramFile.leftOut", {
            count: leftOut.length,
            names: `${leftOut.slice(0, MOST_NAMES).join(", ")}${leftOut.length > MOST_NAMES ? "…" : ""}`,
          })}
        </Notice>
      )}
      {missing.length > 0 && <p>{t("paramFile.missing", { names: missing.join(", ") })}</p>}
    </>
  );
}

function linesOf(diff: Diff): readonly DiffLine[] {
  return diff.kind === "reset"
    ? diff.gains.map(({ name, default: standard }) => ({
        key: name,
        name,
        title: name,
        text: String(standard),
        wanted: standard,
        fault: null,
      }))
    : diff.file.lines.map(fileLine);
}

function fileLine(line: FileLine, index: number): DiffLine {
  const wanted = line.parameter !== null && line.fault === null ? line.value : null;
  const name = line.parameter !== null && line.fault === null ? line.name : null;
  return { key: `${index}`, name, title: line.name, text: line.text, wanted, fault: line.fault };
}

function namesOf(lines: readonly DiffLine[]): string[] {
  return lines.flatMap(({ name }) => (name === null ? [] : [name]));
}
