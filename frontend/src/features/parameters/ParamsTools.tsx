import { Download, FileDown, FolderOpen, Redo2, RotateCcw, Save, Undo2 } from "lucide-react";
import { useState } from "react";
import { useTranslation } from "react-i18next";
import { formatClock } from "../../lib/moment";
import type { ParameterMoves } from "../../protocol/contract";
import { PARAMETERS } from "../../protocol/messages.gen";
import { useAsked } from "../../requests/useAsked";
import { useBoardBlocked } from "../../requests/useBlocked";
import { useConnection, usePage, usePart } from "../../store/hooks";
import { Button } from "../../ui/Button";
import { FileButton } from "../../ui/FileButton";
import { Notice } from "../../ui/Notice";
import type { Diff } from "./DiffDialog";
import { type FileRefusal, readParameterFile, writeParameterFile } from "./parameterFile";
import type { ParameterValues } from "./parameterValues";
import { gainsOf, PARAMETER_REQUESTS, stateOf, useParameters } from "./parameterValues";

interface FileProblem {
  readonly file: string;
  readonly why: FileRefusal | "unreadable";
}

/** The buttons over the gains: what goes between board, card, file and journal. */
export function ParamsTools({ onDiff }: { onDiff: (diff: Diff) => void }) {
  const { t } = useTranslation();
  const parameters = usePart(PARAMETER_REQUESTS);
  const values = useParameters((all) => all);
  const load = useAsked("parameters.load");
  const blocked = useBoardBlocked();
  const [refused, setRefused] = useState<FileProblem | null>(null);
  const gains = gainsOf(values);
  const isKnown = PARAMETERS.every(({ name }) => values.held[name].value !== null);
  // A file has all gains, so those of the board's own have to be known too.
  const incomplete = valuesOf(values) === null ? t("params.loadFirst") : undefined;
  const unknown = isKnown ? undefined : t("params.loadFirst");
  // A choice is made by itself, for it may have to ask first.
  const choices = values.own.table.gains.filter((gain) => gain.choices.length > 0).map(({ name }) => name);
  const resettable = gains.filter(({ name }) => !choices.includes(name));
  const areDefaults = resettable.every((gain) => stateOf(values, gain.name).value === gain.default);

  async function open(file: File): Promise<void> {
    const read = await textOf(file).then(
      (text) => readParameterFile(text, gains),
      () => "unreadable" as const,
    );
    if (typeof read === "string") {
      setRefused({ file: file.name, why: read });
    } else {
      setRefused(null);
      onDiff({ kind: "file", name: file.name, file: read });
    }
  }

  return (
    <>
      <div className="params-tools">
        <Button
          variant="primary"
          onPress={() => void parameters.load({ control: "parameters.load" })}
          state={load.state}
          stateText={load.stateText}
          disabledReason={blocked}
          icon={<Download aria-hidden="true" size={14} />}
        >
          {t("params.load")}
        </Button>
        <StoreButton unknown={unknown} />
        <span className="params-gap" />
        <MoveButton kind="undo" />
        <MoveButton kind="redo" />
        <span className="params-gap" />
        <SaveButton unknown={incomplete} />
        <FileButton
          accept=".json,application/json,.params,.param"
          onFile={(file) => void open(file)}
          disabledReason={blocked ?? unknown}
          icon={<FolderOpen aria-hidden="true" size={14} />}
        >
          {t("params.openFile")}
        </FileButton>
        <Button
          onPress={() => onDiff({ kind: "reset", gains: resettable })}
          disabledReason={blocked ?? unknown ?? (areDefaults ? t("paramDiff.allDefault") : undefined)}
          icon={<RotateCcw aria-hidden="true" size={14} />}
        >
          {t("params.defaults")}
        </Button>
      </div>
      {refused !== null && (
        <Notice level="error" onDismiss={() => setRefused(null)}>
          {t(`paramFile.${refused.why}`, { file: refused.file })}
        </Notice>
      )}
    </>
  );
}

function StoreButton({ unknown }: { unknown: string | undefined }) {
  const { t } = useTranslation();
  const parameters = usePart(PARAMETER_REQUESTS);
  const { state, stateText } = useAsked("parameters.store");
  const blocked = useBoardBlocked();
  const canStore = useConnection(({ status }) => status?.board.features.store === true);
  const unsupported = canStore ? undefined : t("params.storeUnsupported");
  return (
    <Button
      onPress={() => void parameters.store({ control: "parameters.store" })}
      state={state}
      stateText={stateText}
      disabledReason={blocked ?? unsupported ?? unknown}
      icon={<Save aria-hidden="true" size={14} />}
    >
      {t("params.store")}
    </Button>
  );
}

/** Whether what the board has is on its card too: said only where the board has said so. */
export function Stored() {
  const { t } = useTranslation();
  const stored_ms = useParameters((values) => values.stored_ms);
  const canStore = useConnection(({ status }) => status?.board.features.store === true);
  if (!canStore) {
    return null;
  }
  return (
    <p className="params-stored" role="status">
      {stored_ms === null
        ? t("params.notStored")
        : t("params.storedAt", { time: formatClock(stored_ms / 1000) })}
    </p>
  );
}

function MoveButton({ kind }: { kind: "undo" | "redo" }) {
  const { t } = useTranslation();
  const parameters = usePart(PARAMETER_REQUESTS);
  const { state, stateText } = useAsked(`parameters.${kind}`);
  const moves = useParameters(({ journal }) => journal?.[kind] ?? null);
  const blocked = useBoardBlocked();
  const nothing =
    moves === null ? t(kind === "undo" ? "params.undoNothing" : "params.redoNothing") : undefined;
  const what =
    moves === null
      ? undefined
      : t(kind === "undo" ? "params.undoWhat" : "params.redoWhat", { moves: listed(moves) });
  return (
    <Button
      onPress={() => void parameters[kind]({ control: `parameters.${kind}` })}
      state={state}
      stateText={stateText ?? (state === "idle" ? what : undefined)}
      disabledReason={blocked ?? nothing}
      icon={kind === "undo" ? <Undo2 aria-hidden="true" size={14} /> : <Redo2 aria-hidden="true" size={14} />}
    >
      {t(kind === "undo" ? "params.undo" : "params.redo")}
    </Button>
  );

  function listed(all: NonNullable<ParameterMoves>): string {
    return all.map((move) => t("params.move", move)).join(", ");
  }
}

function SaveButton({ unknown }: { unknown: string | undefined }) {
  const { t } = useTranslation();
  const { connection, messages, saveFile } = usePage();
  const parameters = usePart(PARAMETER_REQUESTS);

  function save(): void {
    const values = valuesOf(parameters.values.getState());
    if (values === null) {
      return;
    }
    const now = new Date();
    const firmware = connection.getState().status?.board.firmware ?? null;
    const file = `epf-parameters-${now.toISOString().slice(0, 19).replaceAll(/[-:]/g, "").replace("T", "-")}.json`;
    saveFile(file, new Blob([writeParameterFile(values, firmware, now)], { type: "application/json" }));
    messages.say({ level: "info", key: "params.saidSaved", params: { file } });
  }

  return (
    <Button onPress={save} disabledReason={unknown} icon={<FileDown aria-hidden="true" size={14} />}>
      {t("params.saveFile")}
    </Button>
  );
}

/** Every value, or null when one is not known: a file says what the board has, and nothing else. */
function valuesOf(all: ParameterValues): ReadonlyMap<string, number> | null {
  const values = new Map<string, number>();
  for (const { name } of gainsOf(all)) {
    const { value } = stateOf(all, name);
    if (value === null) {
      return null;
    }
    values.set(name, value);
  }
  return values;
}

/** A file's text, whole or not at all: what is not UTF-8 is not ours. */
async function textOf(file: File): Promise<string> {
  return new TextDecoder("utf-8", { fatal: true }).decode(await file.arrayBuffer());
}
