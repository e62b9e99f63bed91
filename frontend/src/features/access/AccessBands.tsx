import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import type { ControlRequest } from "../../protocol/guards.gen";
import { pageName } from "../../requests/useControl";
import { useAdmission } from "../../requests/useRole";
import { useConnection, usePart } from "../../store/hooks";
import { Button } from "../../ui/Button";
import { Change, useSecondsTo } from "./ControlHolder";
import { NEW_VERSION } from "./newVersion";

/**
 * What everybody at the page must see above all tabs: that the door is open, who asks for control, a newer page. In the window's
 * rows, so that they cover nothing, and without taking the focus: a hand may be on the keyboard.
 */
export function AccessBands() {
  return (
    <>
      <OpenDoor />
      <Requests />
      <Newer />
    </>
  );
}

/** For as long as the station lets anyone fly without a key. */
function OpenDoor() {
  const { t } = useTranslation();
  const isOpen = useAdmission(({ anyoneMayFly }) => anyoneMayFly);
  return isOpen ? (
    <p className="app-open-door" role="alert">
      {t("access.anyoneMayFly")}
    </p>
  ) : null;
}

/** Offered and never forced: a page that is flying goes on as it is. */
function Newer() {
  const { t } = useTranslation();
  const load = useStore(usePart(NEW_VERSION), (version) => version.load);
  return load === null ? null : (
    <div role="status" className="app-new-version">
      <span>{t("access.newVersion")}</span>
      <Button onPress={load}>{t("access.loadNew")}</Button>
    </div>
  );
}

const NOBODY: readonly ControlRequest[] = [];

/** On the page that has control: who asks for it, with both answers. */
function Requests() {
  const { t } = useTranslation();
  const requests = useConnection(({ phase, status, client }) =>
    phase === "open" && client !== null && status?.control.client === client
      ? status.control.requests
      : NOBODY,
  );
  return (
    <div role="status" aria-label={t("control.requests")} className="app-control-requests">
      {requests.map((request) => (
        <Request key={request.client} request={request} />
      ))}
    </div>
  );
}

function Request({ request }: { readonly request: ControlRequest }) {
  const { t } = useTranslation();
  const left_s = useSecondsTo(request.given_at_s);
  const name = pageName(t, request);
  const of = `control.answer.${request.client}`;
  return (
    <div className="app-control-request">
      <strong>{capitalised(t("control.asks", { name }))}</strong>
      <Change change={{ action: "grant", to: request.client }} of={of} variant="primary" blocked={undefined}>
        {t("control.grant")}
      </Change>
      <Change change={{ action: "refuse", to: request.client }} of={of} blocked={undefined}>
        {t("control.refuse")}
      </Change>
      {/* Not part of what is read aloud each second. */}
      <span aria-hidden="true" className="app-control-left">
        {request.given_at_s === null
          ? t("control.keptUntilAnswer")
          : t("control.givenIn", { seconds: left_s })}
      </span>
    </div>
  );
}

/** A sentence that may begin with a name like "the station's computer". */
function capitalised(sentence: string): string {
  return sentence.charAt(0).toLocaleUpperCase() + sentence.slice(1);
}
