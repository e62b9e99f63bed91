import { type ReactNode, useState } from "react";
import { useTranslation } from "react-i18next";
import { ACTIONS, type ControlChange } from "../../requests/actions";
import { useAsked } from "../../requests/useAsked";
import { useOtherHolder } from "../../requests/useControl";
import { useAdmission, useRoleBlocked } from "../../requests/useRole";
import { useConnection, usePart, useTelemetry } from "../../store/hooks";
import { Button } from "../../ui/Button";
import { ConfirmDialog } from "../../ui/ConfirmDialog";
import "./control.css";

interface Props {
  /** Why nothing can be asked now. */
  readonly blocked: string | undefined;
}

/** Who may command, and what this page can do about it: take control while it is free, ask for it, give it back. */
export function ControlHolder({ blocked }: Props) {
  const [takenFrom, setTakenFrom] = useState<string | null>(null);
  return (
    <>
      <Holder blocked={blocked} onTake={setTakenFrom} />
      {takenFrom !== null && <TakeQuestion holder={takenFrom} onAnswer={() => setTakenFrom(null)} />}
    </>
  );
}

interface HolderProps extends Props {
  /** An owner wants control from whoever has it, and has to confirm that. */
  readonly onTake: (holder: string) => void;
}

function Holder({ blocked, onTake }: HolderProps) {
  const { t } = useTranslation();
  const isOpen = useConnection(({ phase, status }) => phase === "open" && status !== null);
  const isMine = useConnection(({ status, client }) => client !== null && status?.control.client === client);
  const holder = useOtherHolder();
  const role = useRoleBlocked("operator");
  if (!isOpen) {
    return <p className="app-control">{t("control.unknown")}</p>;
  }
  if (isMine) {
    return (
      <div className="app-control">
        <p className="app-control-mine">{t("control.mine")}</p>
        <Change change={{ action: "release" }} blocked={blocked}>
          {t("control.release")}
        </Change>
      </div>
    );
  }
  const why = blocked ?? role;
  return (
    <div className="app-control">
      <p>{holder === null ? t("control.free") : t("control.other", { name: holder })}</p>
      {holder === null ? (
        <Change change={{ action: "take" }} blocked={why}>
          {t("control.take")}
        </Change>
      ) : (
        <>
          <Asking blocked={why} />
          <TakeAtOnce onPress={() => onTake(holder)} blocked={why} />
        </>
      )}
    </div>
  );
}

/** Asks whoever has control for it; while the request stands, with the seconds that the holder has left, if time grants it. */
function Asking({ blocked }: Props) {
  const { t } = useTranslation();
  const request = useConnection(({ status, client }) =>
    status?.control.requests.find((one) => one.client === client),
  );
  const given_at_s = request?.given_at_s ?? null;
  const left_s = useSecondsTo(given_at_s);
  if (request === undefined) {
    return (
      <Change change={{ action: "ask" }} blocked={blocked}>
        {t("control.ask")}
      </Change>
    );
  }
  return (
    <>
      <p className="app-control-asked">
        {given_at_s === null ? t("control.askedWaits") : t("control.asked", { seconds: left_s })}
      </p>
      <Change change={{ action: "withdraw" }} blocked={blocked}>
        {t("control.withdraw")}
      </Change>
    </>
  );
}

/** An owner need not wait for the holder, and is asked whether that is meant. */
function TakeAtOnce({ onPress, blocked }: Props & { readonly onPress: () => void }) {
  const { t } = useTranslation();
  const isOwner = useAdmission(({ role }) => role === "owner");
  const { state, stateText } = useAsked("control.take");
  if (!isOwner) {
    return null;
  }
  return (
    <Button onPress={onPress} state={state} stateText={stateText} disabledReason={blocked}>
      {t("control.takeAtOnce")}
    </Button>
  );
}

/** Stays until it is answered: a holder who is lost and comes back meanwhile must not take it from under a finger. */
function TakeQuestion({ holder, onAnswer }: { readonly holder: string; readonly onAnswer: () => void }) {
  const { t } = useTranslation();
  const actions = usePart(ACTIONS);
  return (
    <ConfirmDialog
      title={t("control.takeTitle")}
      text={t("control.takeText", { name: holder })}
      confirmLabel={t("control.takeConfirm")}
      cancelLabel={t("control.takeCancel")}
      danger
      onConfirm={() => {
        onAnswer();
        void actions.changeControl({ action: "take", confirm: true }, { control: "control.take" });
      }}
      onCancel={onAnswer}
    />
  );
}

interface ChangeProps extends Props {
  readonly change: ControlChange;
  /** Whose outcome the button shows, where several stand side by side. */
  readonly of?: string;
  readonly variant?: "plain" | "primary";
  readonly children: ReactNode;
}

/** A button that asks for one change of control and shows what came of it. */
export function Change({ change, of = "control", blocked, variant, children }: ChangeProps) {
  const actions = usePart(ACTIONS);
  const { state, stateText } = useAsked(of);
  return (
    <Button
      onPress={() => void actions.changeControl(change, { control: of })}
      state={state}
      stateText={stateText}
      disabledReason={blocked}
      variant={variant}
    >
      {children}
    </Button>
  );
}

/** Whole seconds until a moment of the station's clock, never below 0; 0 while one of the two is not known. */
export function useSecondsTo(moment_s: number | null): number {
  return useTelemetry((telemetry, now_ms) => {
    const clock_s = telemetry.clock_s(now_ms);
    return moment_s === null || clock_s === null ? 0 : Math.max(0, Math.ceil(moment_s - clock_s));
  });
}
