import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { ACTIONS } from "../../requests/actions";
import { useAsked } from "../../requests/useAsked";
import { useBoardBlocked } from "../../requests/useBlocked";
import { usePart } from "../../store/hooks";
import { Button } from "../../ui/Button";
import { type Automatic, SOURCE_RETURN } from "./sourceReturn";

/** Shows above every tab what a period with RC left off, until it is on again or somebody wants it off. */
export function SourceBanner() {
  const { t } = useTranslation();
  const sourceReturn = usePart(SOURCE_RETURN);
  const leftOff = useStore(sourceReturn, (state) => state.leftOff);
  const names = leftOff.map((name) => t(`flag.${name}`)).join(", ");
  return (
    <div
      role="status"
      aria-label={t("sourceReturn.label")}
      className="app-left-off"
      data-shown={leftOff.length > 0}
    >
      {leftOff.length > 0 && (
        <>
          <strong>{t("sourceReturn.leftOff", { names })}</strong>
          {leftOff.map((name) => (
            <SwitchOn key={name} name={name} />
          ))}
          <Button onPress={() => sourceReturn.setState({ leftOff: [] })}>{t("sourceReturn.keepOff")}</Button>
        </>
      )}
    </div>
  );
}

/** The switch's own command: the switch shows its progress as well. */
function SwitchOn({ name }: { name: Automatic }) {
  const { t } = useTranslation();
  const actions = usePart(ACTIONS);
  const { state, stateText } = useAsked(name);
  const blocked = useBoardBlocked();
  return (
    <Button
      onPress={() => void actions.command(`${name}_on`, { control: name, asked: "on" })}
      state={state}
      stateText={stateText}
      disabledReason={blocked}
    >
      {t(`command.${name}_on`)}
    </Button>
  );
}
