import { FolderOpen } from "lucide-react";
import { useTranslation } from "react-i18next";
import { useSentence } from "../../../i18n/useSentence";
import { useConnection, usePart } from "../../../store/hooks";
import { FileButton } from "../../../ui/FileButton";
import { Notice } from "../../../ui/Notice";
import { isSaved, SURROUNDINGS } from "./surroundings";
import { useFixed, useSurroundings } from "./useSurroundings";

const FORMATS = ["kml", "plan"] as const;

/** The fence from and to files of other programs. What is read is drawn: it is watched once it is saved. */
export function FenceFiles() {
  const { t } = useTranslation();
  const sentence = useSentence();
  const { importFile, forget } = usePart(SURROUNDINGS);
  const said = useSurroundings((state) => state.said);
  const hasSaved = useSurroundings((state) => (state.choice?.corners.length ?? 0) > 0 && isSaved(state));
  const isOpen = useConnection(({ phase }) => phase === "open");
  const fixed = useFixed();
  return (
    <>
      <div className="map-plan-buttons">
        <FileButton
          accept=".kml,.kmz,.plan,.waypoints,.fen,.poly,.txt"
          onFile={(file) => void importFile(file)}
          icon={<FolderOpen size={14} aria-hidden="true" />}
          disabledReason={fixed ?? (isOpen ? undefined : t("blocked.gateway"))}
        >
          {t("map.around.readFile")}
        </FileButton>
        {hasSaved && (
          <ul className="map-track-files" aria-label={t("map.around.files")}>
            {FORMATS.map((format) => (
              <li key={format}>
                <a href={`/api/v1/surroundings/fence?format=${format}`} download={`epf-gcs-fence.${format}`}>
                  {t(format === "kml" ? "map.around.writeKml" : "map.around.writePlan")}
                </a>
              </li>
            ))}
          </ul>
        )}
      </div>
      <p className="map-plan-hint">{t(hasSaved ? "map.around.filesSaved" : "map.around.filesFirst")}</p>
      {said.map((message) => (
        <Notice key={message.key} level={message.level} onDismiss={() => forget(message)}>
          {sentence(message)}
        </Notice>
      ))}
    </>
  );
}
