import { useState } from "react";
import { useTranslation } from "react-i18next";
import { useAsked } from "../../../requests/useAsked";
import { useGatewayBlocked } from "../../../requests/useBlocked";
import { usePart } from "../../../store/hooks";
import { Button } from "../../../ui/Button";
import { ConfirmDialog } from "../../../ui/ConfirmDialog";
import { TRACK_EDITS } from "./trackEdits";
import { useTracks } from "./trackLog";

const RESET = "map.track.reset";
const RESTORE = "map.track.restore";
/** Export formats of the tracks; their names are the same in every language. */
const FILES = ["kml", "kmz", "gpx", "czml"] as const;

/** Buttons to clear, restore and export the tracks. */
export function TrackTools() {
  const { t, i18n } = useTranslation();
  const trackEdits = usePart(TRACK_EDITS);
  const [isAsking, setAsking] = useState(false);
  const canRestore = useTracks((tracks) => tracks.canRestore);
  const points = useTracks(({ summary }) => summary.flight.count + summary.hil.count);
  const blocked = useGatewayBlocked();
  const reset = useAsked(RESET);
  const restore = useAsked(RESTORE);
  return (
    <>
      <div className="map-track-tools">
        <Button
          variant="danger"
          onPress={() => setAsking(true)}
          {...reset}
          disabledReason={blocked ?? (points === 0 ? t("map.track.nothing") : undefined)}
        >
          {t("map.track.reset")}
        </Button>
        {(canRestore === true || restore.state !== "idle") && (
          <Button
            onPress={() => void trackEdits.restore({ control: RESTORE })}
            {...restore}
            disabledReason={blocked ?? (canRestore === true ? undefined : t("map.track.nothingKept"))}
          >
            {t("map.track.restore")}
          </Button>
        )}
      </div>
      <ul className="map-track-files" aria-label={t("map.track.files")}>
        {FILES.map((format) => (
          <li key={format}>
            <a
              href={`/api/v1/track.${format}?lang=${i18n.language}`}
              download={`epf-gcs-track.${format}`}
              aria-label={t("map.track.export", { format: format.toUpperCase() })}
            >
              {format.toUpperCase()}
            </a>
          </li>
        ))}
      </ul>
      {isAsking && (
        <ConfirmDialog
          title={t("map.track.resetTitle")}
          text={t("map.track.resetText")}
          confirmLabel={t("map.track.resetConfirm")}
          cancelLabel={t("map.track.keep")}
          danger
          onConfirm={() => {
            setAsking(false);
            void trackEdits.reset({ control: RESET });
          }}
          onCancel={() => setAsking(false)}
        />
      )}
    </>
  );
}
