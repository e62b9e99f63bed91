import { type DragEvent, type ReactNode, useState } from "react";
import { useTranslation } from "react-i18next";
import { usePart } from "../../store/hooks";
import { FLIGHTS } from "./flightLibrary";
import { useLibraryBlocked } from "./useFlights";

/** Brings in recordings that are dropped anywhere on the tab, and says so while they are over it. */
export function FlightDrop({ children }: { readonly children: ReactNode }) {
  const { t } = useTranslation();
  const { importFile } = usePart(FLIGHTS);
  const blocked = useLibraryBlocked("operator");
  const [isOver, setOver] = useState(false);

  function onDragOver(event: DragEvent): void {
    if (event.dataTransfer.types.includes("Files")) {
      // Without this the browser would open the file in place of the page.
      event.preventDefault();
      setOver(true);
    }
  }

  function onDrop(event: DragEvent): void {
    if (!event.dataTransfer.types.includes("Files")) {
      return;
    }
    event.preventDefault();
    setOver(false);
    for (const file of blocked === undefined ? event.dataTransfer.files : []) {
      void importFile(file);
    }
  }

  return (
    // biome-ignore lint/a11y/noStaticElementInteractions: dropping is an extra for the mouse; the button does the same
    <div
      className="flights"
      onDragOver={onDragOver}
      onDragLeave={({ currentTarget, relatedTarget }) => {
        if (!(relatedTarget instanceof Node && currentTarget.contains(relatedTarget))) setOver(false);
      }}
      onDrop={onDrop}
    >
      {children}
      {isOver && <p className="flights-drop">{blocked ?? t("flights.drop")}</p>}
    </div>
  );
}
