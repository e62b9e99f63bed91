import { useTranslation } from "react-i18next";
import { TRACK_EDITS } from "../../features/map/track/trackEdits";
import { useGatewayBlocked } from "../../requests/useBlocked";
import { usePart } from "../../store/hooks";
import { Menu, MenuAction, MenuLink, MenuRule } from "../../ui/MenuBar";
import { useDialogs } from "../views/useDialogs";
import { useOutcome } from "./items";

export function EarthMenu() {
  const { t, i18n } = useTranslation();
  const query = `?lang=${i18n.language}`;
  return (
    <Menu label={t("menu.earth")}>
      <TrackReset />
      <TrackRestore />
      <MenuRule />
      <MenuLink label={t("menu.openEarth")} href={`/api/v1/earth.kml${query}`} download="epf-gcs.kml" />
      <MenuLink label={t("menu.exportKml")} href={`/api/v1/track.kml${query}`} download="epf-gcs-track.kml" />
    </Menu>
  );
}

function TrackReset() {
  const { t } = useTranslation();
  const trackEdits = usePart(TRACK_EDITS);
  const { ask } = useDialogs();
  return (
    <MenuAction
      label={t("menu.reset")}
      danger
      disabledReason={useGatewayBlocked()}
      onChoose={() =>
        ask({
          title: t("menu.trackResetTitle"),
          text: t("menu.trackResetText"),
          confirm: t("menu.trackResetConfirm"),
          danger: true,
          onConfirm: () => void trackEdits.reset({ control: "track.reset" }),
        })
      }
      {...useOutcome("track.reset")}
    />
  );
}

function TrackRestore() {
  const { t } = useTranslation();
  const trackEdits = usePart(TRACK_EDITS);
  return (
    <MenuAction
      label={t("menu.trackRestore")}
      disabledReason={useGatewayBlocked()}
      onChoose={() => void trackEdits.restore({ control: "track.restore" })}
      {...useOutcome("track.restore")}
    />
  );
}
