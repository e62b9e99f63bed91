import { useEffect, useState } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { pageName } from "../../requests/useControl";
import { useConnection, usePart } from "../../store/hooks";
import { Select } from "../../ui/Select";
import { Change } from "./ControlHolder";
import { CONTROL_PAGES } from "./controlPages";

/** On the page that has control: the other pages that it can be handed over to. */
export function HandOver() {
  const { t } = useTranslation();
  const control = usePart(CONTROL_PAGES);
  const pages = useStore(control.store, (state) => state.pages);
  const client = useConnection((connection) => connection.client);
  const isMine = useConnection(
    (connection) => connection.phase === "open" && connection.status?.control.client === connection.client,
  );
  const [chosen, setChosen] = useState<string | null>(null);
  useEffect(() => (isMine ? control.watch() : undefined), [control, isMine]);
  const others = pages.filter((page) => page.client !== client && page.role !== "viewer");
  if (!isMine || others.length === 0) {
    return null;
  }
  const to = others.find((page) => page.client === chosen)?.client ?? null;
  return (
    <section className="access-row" aria-label={t("control.handOver")}>
      <Select
        label={t("control.handOverTo")}
        options={others.map((page) => ({ value: page.client, label: pageName(t, page) }))}
        value={to}
        onChange={setChosen}
        placeholder={t("control.choosePage")}
      />
      <Change
        change={{ action: "hand_over", to: to ?? "" }}
        of="control.handOver"
        blocked={to === null ? t("control.choosePage") : undefined}
      >
        {t("control.handOver")}
      </Change>
    </section>
  );
}
