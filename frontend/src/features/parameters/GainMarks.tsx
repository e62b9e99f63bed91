import { useTranslation } from "react-i18next";
import type { GainState } from "../../protocol/guards.gen";

interface Props {
  held: Pick<GainState, "value" | "loaded">;
  standard: number;
  /** A value in words. */
  say?: (value: number) => string | number;
}

/** Signs of what a gain differs from: its default, `standard`, and the value that was loaded. */
export function GainMarks({ held: { value, loaded }, standard, say = (value) => value }: Props) {
  const { t } = useTranslation();
  return (
    <div className="params-marks">
      {value !== null && value !== standard && (
        <Mark
          kind="default"
          short={t("params.notDefault")}
          long={t("params.notDefaultLong", { value: say(standard) })}
        />
      )}
      {value !== null && loaded !== null && value !== loaded && (
        <Mark
          kind="loaded"
          short={t("params.notLoaded")}
          long={t("params.notLoadedLong", { value: say(loaded) })}
        />
      )}
    </div>
  );
}

/** A short sign with the whole sentence for pointer and screen reader. */
function Mark({ kind, short, long }: { kind: "default" | "loaded"; short: string; long: string }) {
  return (
    <span className="params-mark" data-kind={kind} title={long}>
      <span aria-hidden="true">{short}</span>
      <span className="visually-hidden">{long}</span>
    </span>
  );
}
