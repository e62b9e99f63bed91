import { useEffect, useRef, useState } from "react";
import { useTranslation } from "react-i18next";
import { useGatewayBlocked } from "../../../requests/useBlocked";
import { usePart } from "../../../store/hooks";
import { MAP_LAYERS } from "./layerList";
import "./layers.css";

/** Imports files that are dropped onto the map, with a hint while they are dragged over it. */
export function MapDrop() {
  const { t } = useTranslation();
  const mapLayers = usePart(MAP_LAYERS);
  const blocked = useGatewayBlocked();
  const mark = useRef<HTMLParagraphElement>(null);
  const [isOver, setOver] = useState(false);
  useEffect(() => {
    const map = mark.current?.parentElement ?? null;
    const carriesFiles = (event: DragEvent): boolean => event.dataTransfer?.types.includes("Files") === true;
    const over = (event: DragEvent): void => {
      if (carriesFiles(event)) {
        // Without this the browser would open the file in place of the page.
        event.preventDefault();
        setOver(true);
      }
    };
    const leave = (event: DragEvent): void => {
      if (!(event.relatedTarget instanceof Node && map?.contains(event.relatedTarget))) setOver(false);
    };
    const drop = (event: DragEvent): void => {
      if (!carriesFiles(event)) return;
      event.preventDefault();
      setOver(false);
      for (const file of blocked === undefined ? (event.dataTransfer?.files ?? []) : []) {
        void mapLayers.importFile(file, { control: "map.import" });
      }
    };
    map?.addEventListener("dragover", over);
    map?.addEventListener("dragleave", leave);
    map?.addEventListener("drop", drop);
    return () => {
      map?.removeEventListener("dragover", over);
      map?.removeEventListener("dragleave", leave);
      map?.removeEventListener("drop", drop);
    };
  }, [mapLayers, blocked]);
  return (
    <p ref={mark} className="map-drop" data-over={isOver} aria-hidden={!isOver}>
      {isOver && (blocked ?? t("map.layers.drop"))}
    </p>
  );
}
