import { Copy, Send, Trash2 } from "lucide-react";
import { useEffect, useRef, useState } from "react";
import { useTranslation } from "react-i18next";
import { useSentence } from "../../i18n/useSentence";
import { formatClock } from "../../lib/moment";
import { useGatewayBlocked } from "../../requests/useBlocked";
import { useConnection, usePart } from "../../store/hooks";
import type { Message } from "../../store/messages";
import { Button } from "../../ui/Button";
import { copyText } from "../../ui/copyText";
import { Notice } from "../../ui/Notice";
import { Panel } from "../../ui/Panel";
import { TextField } from "../../ui/TextField";
import type { ConsoleEntry } from "./consoleLog";
import { BOARD_CONSOLE, useConsole } from "./consoleLog";

/** A line that the gateway accepts for the board's shell: printable ASCII. */
const LINE = /^[\x20-\x7e]{1,200}$/;

/** "Envío y recepción de mensajes por el puerto serie": a line of text to the board, and what came back. */
export function RawLine() {
  const { t } = useTranslation();
  return (
    <Panel title={t("rawLine.title")} className="setup-raw" actions={<LogButtons />}>
      <Sending />
      <Log />
    </Panel>
  );
}

/** Text can be sent over any open link, even before the board sends frames. */
function useLineBlocked(): string | undefined {
  const { t } = useTranslation();
  const gateway = useGatewayBlocked();
  const stands = useConnection(
    ({ status }) => status?.board.state === "open" || status?.board.state === "opening",
  );
  return gateway ?? (stands ? undefined : t("blocked.board"));
}

function Sending() {
  const { t } = useTranslation();
  const boardConsole = usePart(BOARD_CONSOLE);
  const sentence = useSentence();
  const blocked = useLineBlocked();
  const [text, setText] = useState("");
  const [draft, setDraft] = useState("");
  const [problem, setProblem] = useState<Message | null>(null);
  const isRefused = draft !== "" && !LINE.test(draft);

  async function send(line: string): Promise<void> {
    if (!LINE.test(line)) {
      return;
    }
    const failure = await boardConsole.send(line);
    setProblem(failure);
    if (failure === null) {
      setText("");
      setDraft("");
    }
  }

  return (
    <>
      <div className="setup-raw-line">
        <TextField
          label={t("rawLine.line")}
          value={text}
          onCommit={setText}
          onEdit={setDraft}
          onEnter={(line) => void send(line)}
          hint={t("rawLine.hint")}
          error={isRefused ? t("rawLine.notAscii") : undefined}
          disabledReason={blocked}
          monospace
        />
        <Button
          onPress={() => void send(draft)}
          disabledReason={blocked ?? (draft === "" ? t("rawLine.empty") : undefined)}
          icon={<Send aria-hidden="true" size={14} />}
        >
          {t("rawLine.send")}
        </Button>
      </div>
      {problem !== null && <Notice level="error">{sentence(problem)}</Notice>}
    </>
  );
}

function LogButtons() {
  const { t } = useTranslation();
  const boardConsole = usePart(BOARD_CONSOLE);
  const isEmpty = useConsole().entries.length === 0;
  const [copied, setCopied] = useState<"idle" | "confirmed" | "rejected">("idle");
  const nothing = isEmpty ? t("rawLine.nothing") : undefined;
  return (
    <>
      <Button
        onPress={() => {
          const lines = boardConsole.store.getState().entries.map(lineOf).join("\n");
          void copyText(lines).then((isCopied) => setCopied(isCopied ? "confirmed" : "rejected"));
        }}
        state={isEmpty ? "idle" : copied}
        stateText={copied === "rejected" ? t("rawLine.notCopied") : undefined}
        disabledReason={nothing}
        icon={<Copy aria-hidden="true" size={14} />}
      >
        {t("rawLine.copy")}
      </Button>
      <Button
        onPress={() => {
          boardConsole.clear();
          setCopied("idle");
        }}
        disabledReason={nothing}
        icon={<Trash2 aria-hidden="true" size={14} />}
      >
        {t("rawLine.clear")}
      </Button>
    </>
  );
}

const ARROWS = { sent: "→", received: "←" } as const;

function lineOf({ at_ms, direction, text }: ConsoleEntry): string {
  return `${formatClock(at_ms / 1000)} ${ARROWS[direction]} ${text}`;
}

/** Scrolls to the newest line, unless the user has scrolled up. */
function Log() {
  const { t } = useTranslation();
  const { entries, dropped } = useConsole();
  const box = useRef<HTMLDivElement>(null);
  const isAtEnd = useRef(true);
  const newest = entries.at(-1)?.number;
  useEffect(() => {
    if (box.current !== null && newest !== undefined && isAtEnd.current) {
      box.current.scrollTop = box.current.scrollHeight;
    }
  }, [newest]);
  return (
    <div
      ref={box}
      className="setup-log"
      role="log"
      aria-label={t("rawLine.log")}
      // biome-ignore lint/a11y/noNoninteractiveTabindex: the keyboard must be able to scroll it
      tabIndex={0}
      onScroll={({ currentTarget: { scrollTop, scrollHeight, clientHeight } }) => {
        isAtEnd.current = scrollTop + clientHeight >= scrollHeight - 8;
      }}
    >
      {entries.length === 0 && <p className="setup-log-empty">{t("rawLine.nothing")}</p>}
      {dropped > 0 && <p className="setup-log-empty">{t("rawLine.dropped", { number: dropped })}</p>}
      {entries.map((entry) => (
        <p key={entry.number} className="setup-log-line" data-direction={entry.direction}>
          <span className="setup-log-time">{formatClock(entry.at_ms / 1000)}</span>
          <span aria-hidden="true">{ARROWS[entry.direction]}</span>
          <span className="visually-hidden">{t(`rawLine.${entry.direction}`)}</span>
          <span className="setup-log-text">{entry.text}</span>
        </p>
      ))}
    </div>
  );
}
