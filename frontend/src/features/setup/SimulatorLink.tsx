import { Plug, Unplug } from "lucide-react";
import { useState } from "react";
import { useTranslation } from "react-i18next";
import { useSentence } from "../../i18n/useSentence";
import { formatFixed } from "../../lib/format";
import type { SimulatorLink as Link } from "../../requests/actions";
import { ACTIONS } from "../../requests/actions";
import { useAsked } from "../../requests/useAsked";
import { useGatewayBlocked } from "../../requests/useBlocked";
import { useReread } from "../../requests/useReread";
import { useCommandEntry, useConnection, usePage, usePart, useSettings } from "../../store/hooks";
import { failureMessage } from "../../store/messages";
import { choose } from "../../store/settings";
import { Button } from "../../ui/Button";
import { Checkbox } from "../../ui/Checkbox";
import { Notice } from "../../ui/Notice";
import { NumberField } from "../../ui/NumberField";
import { EditScope } from "../../ui/openEdits";
import { Panel } from "../../ui/Panel";
import { Select } from "../../ui/Select";
import { TextField } from "../../ui/TextField";
import { Facts } from "./Facts";
import { useRowName } from "./RowTable";

const RECEIVE_PORT = 49003;
const SEND_PORT = 49000;
const PROFILES = ["xp10", "xp12"] as const;
/** X-Plane says once a second that it is there. */
const LOOK_EVERY_MS = 2_000;

/** "XPlane": where the simulator is, which ports, and what comes from it. */
export function SimulatorLink() {
  const { t } = useTranslation();
  return (
    <Panel title={t("setup.simulator")} className="setup-simulator">
      <EditScope>
        <SimulatorForm />
      </EditScope>
      <SimulatorFacts />
    </Panel>
  );
}

function port(text: string | undefined, fallback: number): number {
  const number = Number(text);
  return Number.isInteger(number) && number >= 1 && number <= 65535 ? number : fallback;
}

/** The fields as last entered here; else those of the open link; else the defaults. */
function useLink(): Link {
  const choices = useSettings((settings) => settings.choices);
  const open = useConnection(({ status }) => status?.simulator);
  const profile = choices["simulator.profile"];
  return {
    send_host: choices["simulator.host"] ?? open?.send_host ?? "127.0.0.1",
    send_port: port(choices["simulator.sendPort"], open?.send_port ?? SEND_PORT),
    receive_port: port(choices["simulator.receivePort"], open?.receive_port ?? RECEIVE_PORT),
    profile: PROFILES.find((known) => known === profile) ?? open?.profile ?? "xp10",
    tells_rows: (choices["simulator.tellsRows"] ?? `${open?.tells_rows}`) === "true",
  };
}

/** The link that is open, as it is, whatever is written in the fields. */
function useOpenLink(): Link | null {
  const open = useConnection(({ status }) => status?.simulator);
  if (
    open?.send_host == null ||
    open.send_port === null ||
    open.receive_port === null ||
    open.profile === null
  ) {
    return null;
  }
  const { send_host, send_port, receive_port, profile, tells_rows } = open;
  return { send_host, send_port, receive_port, profile, tells_rows };
}

/** Address, ports, open and close, and what is not received. */
export function SimulatorForm() {
  const { t } = useTranslation();
  const { settings } = usePage();
  const actions = usePart(ACTIONS);
  const sentence = useSentence();
  const link = useLink();
  const [draft, setDraft] = useState<string | null>(null);
  const host = (draft ?? link.send_host).trim();
  const state = useConnection(({ status }) => status?.simulator.state ?? "closed");
  const opening = useAsked("simulator");
  const refusal = useCommandEntry("simulator")?.message ?? null;
  const failure = useConnection(({ status }) => status?.simulator.failure ?? null);
  const notice = failure === null ? refusal : failureMessage(failure);
  const blocked = useGatewayBlocked();
  return (
    <div className="setup-form">
      <HeardSimulators link={link} />
      <div className="setup-row">
        <TextField
          label={t("setup.host")}
          value={link.send_host}
          onCommit={(value) => {
            setDraft(null);
            choose(settings, "simulator.host", value.trim());
          }}
          onEdit={setDraft}
          monospace
        />
        <Select
          label={t("setup.profile")}
          options={PROFILES.map((value) => ({ value, label: t(`profile.${value}`) }))}
          value={link.profile}
          onChange={(value) => choose(settings, "simulator.profile", value)}
          placeholder={t("setup.profile")}
        />
      </div>
      <div className="setup-row">
        <NumberField
          label={t("setup.sendPort")}
          value={link.send_port}
          onCommit={(value) => choose(settings, "simulator.sendPort", String(value))}
          minimum={1}
          maximum={65535}
          step={1}
        />
        <NumberField
          label={t("setup.receivePort")}
          value={link.receive_port}
          onCommit={(value) => choose(settings, "simulator.receivePort", String(value))}
          minimum={1}
          maximum={65535}
          step={1}
        />
      </div>
      <Checkbox
        label={t("setup.tellsRows")}
        checked={link.tells_rows}
        onChange={(checked) => choose(settings, "simulator.tellsRows", String(checked))}
      />
      <div className="setup-buttons">
        <Button
          takesFields
          variant={state === "closed" ? "primary" : "plain"}
          onPress={() => void actions.openSimulator({ ...link, send_host: host }, { control: "simulator" })}
          state={opening.wanted === "close" ? "idle" : opening.state}
          disabledReason={blocked ?? (host === "" ? t("setup.noHost") : undefined)}
          icon={<Plug aria-hidden="true" size={14} />}
        >
          {t("setup.open")}
        </Button>
        <Button
          onPress={() => void actions.closeSimulator({ control: "simulator", asked: "close" })}
          disabledReason={blocked ?? (state === "closed" ? t("setup.alreadyClosed") : undefined)}
          icon={<Unplug aria-hidden="true" size={14} />}
        >
          {t("setup.close")}
        </Button>
      </div>
      {notice?.level === "error" && <Notice level="error">{sentence(notice)}</Notice>}
      <Advice />
    </div>
  );
}

/** The X-Planes that say on the network that they are there; one that is chosen fills the fields below. */
function HeardSimulators({ link }: { readonly link: Link }) {
  const { t } = useTranslation();
  const { settings } = usePage();
  const heard = useReread(usePart(ACTIONS).listSimulators, LOOK_EVERY_MS);
  const known = heard ?? [];
  const chosen = known.find(({ host, port: at }) => host === link.send_host && at === link.send_port);
  const place = ({ host, port: at }: { host: string; port: number }): string => `${host}:${at}`;
  return (
    <Select
      label={t("setup.heard")}
      options={known.map((one) => ({
        value: place(one),
        label: `${one.name} · X-Plane ${one.version} · ${one.host}`,
      }))}
      value={chosen === undefined ? null : place(chosen)}
      onChange={(value) => {
        const one = known.find((each) => place(each) === value);
        if (one === undefined) return;
        choose(settings, "simulator.host", one.host);
        choose(settings, "simulator.sendPort", String(one.port));
        choose(settings, "simulator.profile", one.profile);
        choose(settings, "simulator.tellsRows", "true");
      }}
      placeholder={
        heard === null
          ? t("setup.listening")
          : known.length === 0
            ? t("setup.noneHeard")
            : t("setup.chooseHeard", { count: known.length })
      }
    />
  );
}

/** What is not received although the port is open. */
function Advice() {
  const { t } = useTranslation();
  const state = useConnection(({ status, phase }) =>
    phase === "open" ? status?.simulator.state : undefined,
  );
  const missing = useConnection(({ status }) => status?.simulator.missing_rows.join(", ") ?? "");
  const isTold = useConnection(({ status }) => status?.simulator.tells_rows === true);
  if (state === "opening") {
    return <Notice level="info">{t(isTold ? "setup.toldNothingHeard" : "setup.nothingHeard")}</Notice>;
  }
  return state !== "open" ? null : (
    <>
      {missing !== "" && <Notice level="warning">{t("setup.missingRows", { rows: missing })}</Notice>}
      <UnusableValue />
      <OtherProfile />
    </>
  );
}

/** The first value that the board needs and that cannot be used. */
function UnusableValue() {
  const { t } = useTranslation();
  const value = useConnection(({ status }) => status?.simulator.unusable[0]);
  const rowName = useRowName(value?.row ?? 0);
  return value === undefined ? null : (
    <Notice level="warning">{t("setup.unusable", { ...value, rowName })}</Notice>
  );
}

/** The rows are of another generation of the simulator than they are read as: it can be opened as that one. */
function OtherProfile() {
  const { t } = useTranslation();
  const { settings } = usePage();
  const actions = usePart(ACTIONS);
  const link = useOpenLink();
  const fits = useConnection(({ status }) => status?.simulator.fitting_profile ?? null);
  const { state } = useAsked("simulator");
  const blocked = useGatewayBlocked();
  if (link === null || fits === null || fits === link.profile) {
    return null;
  }
  const name = t(`profile.${fits}`);
  return (
    <>
      <Notice level="error">{t("setup.otherProfile", { fits: name })}</Notice>
      <Button
        variant="primary"
        onPress={() => {
          choose(settings, "simulator.profile", fits);
          void actions.openSimulator({ ...link, profile: fits }, { control: "simulator" });
        }}
        state={state}
        disabledReason={blocked}
      >
        {t("setup.useProfile", { fits: name })}
      </Button>
    </>
  );
}

function SimulatorFacts() {
  const { t } = useTranslation();
  const simulator = useConnection(({ status, phase }) =>
    phase === "open" ? (status?.simulator ?? null) : null,
  );
  if (simulator === null) {
    return <Facts facts={[[t("setup.state"), t("link.unknown")]]} />;
  }
  const { newest, p99 } = simulator.hil_round_trip_ms;
  const newestText = formatFixed(newest, 1);
  const dash = t("words.dash");
  return (
    <Facts
      facts={[
        [t("setup.state"), t(`link.${simulator.state}`)],
        [
          t("setup.rows", { number: simulator.rows.length }),
          simulator.rows.length === 0 ? dash : simulator.rows.join(", "),
        ],
        [t("setup.datagramsReceived"), String(simulator.datagrams_received)],
        [t("setup.datagramsDropped"), String(simulator.datagrams_dropped)],
        [
          t("setup.roundTrip"),
          newestText === null
            ? dash
            : t("setup.roundTripValue", { newest: newestText, p99: formatFixed(p99, 1) ?? dash }),
        ],
      ]}
    />
  );
}
