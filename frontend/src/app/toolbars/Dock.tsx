import type { ReactNode } from "react";
import { useTranslation } from "react-i18next";
import { MovableToolbar, usePlace } from "./MovableToolbar";
import type { Edge } from "./places";
import { AutomaticControls, SignalControls } from "./Toolbars";

/** The two toolbars, in their order. */
export const BARS = ["automatic", "signal"] as const;
type BarName = (typeof BARS)[number];

const CONTROLS: Readonly<Record<BarName, () => ReactNode>> = {
  automatic: () => <AutomaticControls />,
  signal: () => <SignalControls />,
};

/** The toolbars at one edge of the window, or the floating ones. Takes no room when there is none. */
export function Dock({ edge }: { edge: Edge | "floating" }) {
  const { t } = useTranslation();
  const places = { automatic: usePlace("automatic"), signal: usePlace("signal") };
  const here = BARS.filter((name) => {
    const place = places[name];
    return edge === ("edge" in place ? place.edge : "floating");
  });
  return here.length === 0 ? null : (
    <section
      className="app-dock"
      data-edge={edge}
      aria-label={t("place.dock", { place: t(`place.${edge}`) })}
    >
      {here.map((name) => (
        <MovableToolbar key={name} name={name} label={t(`toolbar.${name}`)}>
          {CONTROLS[name]()}
        </MovableToolbar>
      ))}
    </section>
  );
}
