import { type ReactNode, useEffect, useState } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useSentence } from "../../i18n/useSentence";
import { useAdmission } from "../../requests/useRole";
import { usePage, usePart, useSettings } from "../../store/hooks";
import { choose, LANGUAGES } from "../../store/settings";
import { Button } from "../../ui/Button";
import { Notice } from "../../ui/Notice";
import { SegmentedSwitch } from "../../ui/SegmentedSwitch";
import { TextField } from "../../ui/TextField";
import { keepsCookies } from "./cookies";
import { deviceKind } from "./device";
import "./enter.css";
import { ENTRY, type Who } from "./entry";
import { readKey } from "./keyAddress";
import { TrustForStrangers } from "./Trust";

/** All that a stranger sees: the way in with a one-time key, or by asking the owner. Made for a phone. */
export function EnterPage() {
  const { t } = useTranslation();
  const isWaiting = useAdmission(({ state }) => state === "waiting");
  const { store, isEncrypted } = usePart(ENTRY);
  const { message } = useStore(store);
  const sentence = useSentence();
  const [isKnown] = useState(() => keepsCookies(window));
  return (
    <main className="enter">
      <div className="enter-card">
        <header className="enter-head">
          <h1>{t("access.enterTitle")}</h1>
          <LanguageSwitch />
        </header>
        {!isKnown && <Notice level="warning">{t("access.cookiesOff")}</Notice>}
        {message !== null && (
          <Notice level={message.level === "info" ? "info" : message.level}>{sentence(message)}</Notice>
        )}
        {isWaiting ? <Waiting /> : <Form isKnown={isKnown} />}
        {isEncrypted && <TrustForStrangers />}
      </div>
    </main>
  );
}

function LanguageSwitch() {
  const { t } = useTranslation();
  const { settings } = usePage();
  return (
    <SegmentedSwitch
      label={t("app.language")}
      hideLabel
      options={LANGUAGES.map((value) => ({ value, label: t(`language.${value}`) }))}
      value={useSettings(({ language }) => language)}
      onChange={(language) => settings.setState({ language })}
    />
  );
}

/** `isKnown`: the browser keeps the cookie that comes with entering; without it a key would be spent for nothing. */
function Form({ isKnown }: { readonly isKnown: boolean }) {
  const { t } = useTranslation();
  const entry = usePart(ENTRY);
  const { key: addressed, isAsking } = useStore(entry.store);
  const { who, fields, isNamed } = useWho();
  const [typed, setTyped] = useState("");
  const key = addressed ?? typed;
  const retry_s = useSecondsLeft();
  const reason =
    retry_s > 0
      ? t("access.retryIn", { seconds: retry_s })
      : isAsking
        ? t("words.pending")
        : !isKnown
          ? t("access.cookiesOff")
          : isNamed
            ? undefined
            : t("access.nameFirst");

  function enter(): void {
    if (reason === undefined && key !== "") {
      void entry.enter(readKey(key), who);
    }
  }

  return (
    <>
      {fields}
      <section className="enter-way" aria-label={t("access.withKey")}>
        {addressed === null ? (
          <TextField
            label={t("access.key")}
            hint={t("access.keyHint")}
            value={typed}
            onEdit={setTyped}
            onCommit={setTyped}
            onEnter={enter}
            monospace
          />
        ) : (
          <Notice level="info">{t("access.keyArrived")}</Notice>
        )}
        <Button
          variant="primary"
          onPress={enter}
          disabledReason={reason ?? (key === "" ? t("access.keyFirst") : undefined)}
        >
          {t("access.enter")}
        </Button>
      </section>
      <section className="enter-way" aria-label={t("access.withoutKey")}>
        <p>{t("access.withoutKeyHint")}</p>
        <Button onPress={() => void entry.ask(who)} disabledReason={reason}>
          {t("access.ask")}
        </Button>
      </section>
      {retry_s > 0 && (
        <p className="enter-retry" role="timer">
          {t("access.retryIn", { seconds: retry_s })}
        </p>
      )}
    </>
  );
}

/** Name and place, remembered by this browser. */
function useWho(): { who: Who; fields: ReactNode; isNamed: boolean } {
  const { t } = useTranslation();
  const { settings } = usePage();
  const name = useSettings(({ choices }) => choices["access.name"] ?? "");
  const guessed = t(`device.${deviceKind(window)}`);
  const place = useSettings(({ choices }) => choices["access.place"]) ?? guessed;
  const [edited, setEdited] = useState<Partial<Who>>({});
  const who = { name: (edited.name ?? name).trim(), place: (edited.place ?? place).trim() };

  function field(which: keyof Who, value: string) {
    return (
      <TextField
        label={t(`access.${which}`)}
        hint={t(`access.${which}Hint`)}
        value={value}
        onEdit={(text) => setEdited((before) => ({ ...before, [which]: text }))}
        onCommit={(text) => choose(settings, `access.${which}`, text.trim())}
      />
    );
  }

  const fields = (
    <section className="enter-way" aria-label={t("access.who")}>
      {field("name", name)}
      {field("place", place)}
    </section>
  );
  return { who, fields, isNamed: who.name !== "" && who.place !== "" };
}

/** Whole seconds until the station takes another try; 0 if it takes one now. */
function useSecondsLeft(): number {
  const entry = usePart(ENTRY);
  const retry_ms = useStore(entry.store, (state) => state.retry_ms);
  const [now_ms, setNow] = useState(entry.now_ms);
  const left_ms = retry_ms === null ? 0 : Math.max(0, retry_ms - Math.max(now_ms, entry.now_ms()));
  useEffect(
    () => (left_ms > 0 ? entry.after(Math.min(1000, left_ms), () => setNow(entry.now_ms())) : undefined),
    [entry, left_ms],
  );
  return Math.ceil(left_ms / 1000);
}

function Waiting() {
  const { t } = useTranslation();
  const entry = usePart(ENTRY);
  return (
    <section className="enter-way" aria-label={t("access.waiting")}>
      <p className="enter-waiting" role="status">
        {t("access.waiting")}
      </p>
      <p>{t("access.waitingHint")}</p>
      <Button onPress={() => void entry.leave()}>{t("access.stopWaiting")}</Button>
    </section>
  );
}
