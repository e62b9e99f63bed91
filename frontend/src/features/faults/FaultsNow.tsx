import { OctagonX } from "lucide-react";
import { useTranslation } from "react-i18next";
import { useAsked } from "../../requests/useAsked";
import { useAdmission } from "../../requests/useRole";
import { useConnection, usePage, usePart } from "../../store/hooks";
import { Button } from "../../ui/Button";
import { END_ALL, FAULTS } from "./faultRequests";
import { faultSentence } from "./faultWords";
import "./faults.css";

/** What goes wrong in the simulator now, for everybody, in a line that is there anyway; an owner ends all of it here. */
export function FaultsNow() {
  const { t } = useTranslation();
  const flown = useConnection(({ phase, status }) =>
    phase === "open" ? (status?.simulator.faults?.faults ?? null) : null,
  );
  const isOwner = useAdmission(({ role }) => role === "owner");
  const isPast = usePage().past !== null;
  const now = (flown ?? []).filter(({ is_on }) => is_on);
  const [first] = now;
  const said =
    first === undefined
      ? ""
      : t("faults.now", { count: now.length, first: faultSentence(t, first), more: now.length - 1 });
  return (
    <div className="faults-now" data-shown={first !== undefined}>
      <span
        role="status"
        className="faults-now-text"
        title={now.map((one) => faultSentence(t, one)).join("\n")}
      >
        {said}
      </span>
      {first !== undefined && isOwner && !isPast && <EndAll isShort />}
    </div>
  );
}

interface EndAllProps {
  readonly disabledReason?: string | undefined;
  /** Where there is little room: the whole sentence is its name. */
  readonly isShort?: boolean;
}

export function EndAll({ disabledReason, isShort = false }: EndAllProps) {
  const { t } = useTranslation();
  const { end } = usePart(FAULTS);
  const { state, stateText } = useAsked(END_ALL);
  return (
    <Button
      variant="danger"
      onPress={() => void end()}
      state={state}
      stateText={stateText}
      disabledReason={disabledReason}
      label={t("faults.endAll")}
      icon={<OctagonX aria-hidden="true" size={14} />}
    >
      {t(isShort ? "faults.end" : "faults.endAll")}
    </Button>
  );
}
