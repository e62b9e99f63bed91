import { Download, FileDown, FolderOpen, Redo2, RotateCcw, Save, Undo2 } from "lucide-react";
import { useState } from "react";
import { useTranslation } from "react-i18next";
import { formatClock } from "../../lib/moment";
import type { ParameterMoves } from "../../protocol/contract";
import { PARAMETERS, type ParameterName } from "../../protocol/messages.gen";
import { useAsked } from "../../requests/useAsked";
import { useBoardBlocked } from "../../requests/useBlocked";
import { useConnection, usePage, usePart } from "../../store/hooks";
import { Button } from "../../ui/Button";
import { FileButton } from "../../ui/FileButton";
import { Notice } from "../../ui/Notice";
import type { Diff } from "./DiffDialog";
import { type FileRefusal, readParameterFile, writeParameterFile } from "./parameterFile";
import type { ParameterValues } from "./parameterValues";
import { PARAMETER_REQUESTS, useParameters } from "./parameterValues";

interface FileProblem {
  readonly file: string;
  readonly why: FileRefusal | "unreadable";
}

/** The buttons over the gains: what goes between board, card, file and journal. */
export function ParamsTools({ onDiff }: { onDiff: (diff: Diff) => void }) {
  const { t } = useTranslation();
  const parameters = usePart(PARAMETER_REQUESTS);
  const held = useParameters((values) => values.held);
  const load = useAsked("parameters.load");
  const blocked = useBoardBlocked();
  const [refused, setRefused] = useState<FileProblem | null>(null);
  const isKnown = PARAMETERS.every(({ name }) => held[name].value !== null);
  const unknown = isKnown ? undefined : t("params.loadFirst");
  const areDefaults = PARAMETERS.every((info) => held[info.name].value === info.default);

  async function open(file: File): Promise<void> {
    const read = await textOf(file).then(readParameterFile, () => "unreadable" as const);
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
        <SaveButton unknown={unknown} />
        <FileButton
          accept=".json,application/json,.params,.param"
          onFile={(file) => void open(file)}
          disabledReason={blocked ?? unknown}
          icon={<FolderOpen aria-hidden="true" size={14} />}
        >
          {t("params.openFile")}
        </FileButton>
        <Button
          onPress={() => onDiff({ kind: "reset", names: PARAMETERS.map(({ name }) => name) })}
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
    const { held } = parameters.values.getState();
    const values = valuesOf(held);
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
function valuesOf(held: ParameterValues["held"]): Readonly<Record<ParameterName, number>> | null {
  const values: Partial<Record<ParameterName, number>> = {};
  for (const { name } of PARAMETERS) {
    const { value } = held[name];
    if (value === null) {
      return null;
    }
    values[name] = value;
  }
  return values as Record<ParameterName, number>;
}

/** A file's text, whole or not at all: what is not UTF-8 is not ours. */
async function textOf(file: File): Promise<string> {
  return new TextDecoder("utf-8", { fatal: true }).decode(await file.arrayBuffer());
}
