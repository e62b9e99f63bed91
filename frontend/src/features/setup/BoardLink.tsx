import { Plug, RefreshCw, Unplug } from "lucide-react";
import { useState } from "react";
import { useTranslation } from "react-i18next";
import { useSentence } from "../../i18n/useSentence";
import type { Port } from "../../requests/actions";
import { ACTIONS } from "../../requests/actions";
import { useAsked } from "../../requests/useAsked";
import { useGatewayBlocked } from "../../requests/useBlocked";
import { useCommandEntry, useConnection, usePage, usePart, useSettings } from "../../store/hooks";
import { failureMessage } from "../../store/messages";
import { choose } from "../../store/settings";
import { Button } from "../../ui/Button";
import { Notice } from "../../ui/Notice";
import { Panel } from "../../ui/Panel";
import { Select } from "../../ui/Select";
import { TextField } from "../../ui/TextField";
import { BAUDS, type BoardChoice, boardUrl, choiceOf, isBaud, OTHER } from "./address";
import { Facts } from "./Facts";
import { usePorts } from "./usePorts";

/** "Comunicación con el Piloto Automático": which port, how fast, open and close. */
export function BoardLink() {
  const { t } = useTranslation();
  return (
    <Panel title={t("setup.board")} className="setup-board">
      <BoardForm />
      <BoardFacts />
    </Panel>
  );
}

/** Port, speed, open and close, and why it could not be opened. */
export function BoardForm() {
  const { t } = useTranslation();
  const { settings } = usePage();
  const sentence = useSentence();
  const list = usePorts();
  const choice = useBoardChoice(list.ports);
  // The text being typed already decides whether the link can be opened.
  const [typed, setTyped] = useState<string | null>(null);
  return (
    <div className="setup-form">
      <div className="setup-row">
        <Select
          label={t("setup.port")}
          options={choice.options}
          value={choice.port}
          onChange={(port) => choose(settings, "board.port", port)}
          placeholder={t("setup.choosePort")}
        />
        <Button
          onPress={list.refresh}
          state={list.isLoading ? "pending" : "idle"}
          icon={<RefreshCw aria-hidden="true" size={14} />}
        >
          {t("setup.refresh")}
        </Button>
        <Select
          label={t("setup.baud")}
          options={BAUDS.map((value) => ({ value, label: value }))}
          value={choice.baud}
          onChange={(value) => choose(settings, "board.baud", value)}
          placeholder={t("setup.baud")}
        />
      </div>
      {choice.port === OTHER && (
        <TextField
          label={t("setup.address")}
          value={choice.address}
          onCommit={(address) => {
            choose(settings, "board.address", address);
            setTyped(null);
          }}
          onEdit={(text) => setTyped(text === choice.address ? null : text)}
          placeholder={t("setup.addressExample")}
          hint={t("setup.addressHint")}
          monospace
        />
      )}
      {list.problem !== null && <Notice level="error">{sentence(list.problem)}</Notice>}
      <BoardButtons url={boardUrl({ ...choice, address: typed ?? choice.address })} />
    </div>
  );
}

interface Choice extends BoardChoice {
  readonly options: ReadonlyArray<{ readonly value: string; readonly label: string }>;
}

/** The last choice, and the ports to choose from. */
function useBoardChoice(ports: readonly Port[]): Choice {
  const { t } = useTranslation();
  const open = choiceOf(useConnection(({ status }) => status?.board.url ?? null));
  const chosen = useSettings(({ choices }) => choices["board.port"]) ?? open.port;
  const address = useSettings(({ choices }) => choices["board.address"]) ?? open.address;
  const baud = useSettings(({ choices }) => choices["board.baud"]);
  const listed = ports.map(({ device, description }) => ({
    value: device,
    label: description === "" ? device : `${device} · ${description}`,
  }));
  // A chosen port that is unplugged stays in the list: its name says what is missing.
  const isMissing = chosen !== null && chosen !== OTHER && !ports.some(({ device }) => device === chosen);
  const missing = isMissing ? [{ value: chosen, label: t("setup.portMissing", { port: chosen }) }] : [];
  return {
    port: chosen ?? (listed.length === 0 ? OTHER : null),
    baud: isBaud(baud) ? baud : open.baud,
    address,
    options: [...listed, ...missing, { value: OTHER, label: t("setup.otherAddress") }],
  };
}

function BoardButtons({ url }: { url: string | null }) {
  const { t } = useTranslation();
  const actions = usePart(ACTIONS);
  const sentence = useSentence();
  const isClosed = useConnection(({ status }) => (status?.board.state ?? "closed") === "closed");
  const { state, wanted } = useAsked("board");
  const refusal = useCommandEntry("board")?.message ?? null;
  const failure = useConnection(({ status }) => status?.board.failure ?? null);
  // The link's failure is shown while it lasts; the refusal of a click, until the next one.
  const notice = failure === null ? refusal : failureMessage(failure);
  const blocked = useGatewayBlocked();
  return (
    <>
      <div className="setup-buttons">
        <Button
          variant={isClosed ? "primary" : "plain"}
          onPress={() => {
            if (url !== null) {
              void actions.openBoard(url, { control: "board" });
            }
          }}
          state={wanted === "close" ? "idle" : state}
          disabledReason={blocked ?? (url === null ? t("setup.nothingToOpen") : undefined)}
          icon={<Plug aria-hidden="true" size={14} />}
        >
          {t("setup.open")}
        </Button>
        <Button
          onPress={() => void actions.closeBoard({ control: "board", asked: "close" })}
          disabledReason={blocked ?? (isClosed ? t("setup.alreadyClosed") : undefined)}
          icon={<Unplug aria-hidden="true" size={14} />}
        >
          {t("setup.close")}
        </Button>
      </div>
      {notice?.level === "error" && <Notice level="error">{sentence(notice)}</Notice>}
    </>
  );
}

/** What the gateway reports about the link. */
function BoardFacts() {
  const { t } = useTranslation();
  const board = useConnection(({ status, phase }) => (phase === "open" ? (status?.board ?? null) : null));
  if (board === null) {
    return <Facts facts={[[t("setup.state"), t("link.unknown")]]} />;
  }
  const mode = board.mode === null ? t("words.unknown") : t(`mode.${board.mode}`);
  const firmware = [board.firmware?.name, board.firmware?.version].filter(Boolean).join(" ");
  return (
    <Facts
      facts={[
        [t("setup.state"), t(`link.${board.state}`)],
        [t("setup.line"), board.url ?? t("words.dash")],
        [t("setup.mode"), board.state === "open" ? mode : t("words.dash")],
        [t("setup.firmware"), firmware === "" ? t("words.dash") : firmware],
        [t("setup.reopened"), String(board.reopened)],
        [t("setup.framesReceived"), String(board.frames_received)],
        [t("setup.framesDamaged"), String(board.frames_damaged)],
      ]}
    />
  );
}
