import { useTranslation } from "react-i18next";
import type { OwnGainDefinition } from "../../protocol/guards.gen";
import { Notice } from "../../ui/Notice";
import { Panel } from "../../ui/Panel";
import { OwnGainRow } from "./OwnGainRow";
import { useParameters } from "./parameterValues";

/** What the page calls a group of the board's own gains: in its own words where it has some, else in the board's. */
export function useGroupName(): (group: string) => string {
  const { t, i18n } = useTranslation();
  return (group) =>
    i18n.exists(`ownGroup.${group}`) ? t(`ownGroup.${group}` as never) : group.replaceAll("_", " ");
}

/** The gains that the board describes itself, by group; `gains` are those that search and filter let through. */
export function OwnGains({ gains }: { gains: readonly OwnGainDefinition[] }) {
  const groupName = useGroupName();
  const groups = [...new Set(gains.map(({ group }) => group))];
  return groups.map((group) => (
    <Panel key={group} title={groupName(group)} className="params-own">
      {gains
        .filter((gain) => gain.group === group)
        .map((gain) => (
          <OwnGainRow key={gain.name} gain={gain} />
        ))}
    </Panel>
  ));
}

/** How far the board's table is known, and which of its rows cannot be used. */
export function OwnTableState() {
  const { t } = useTranslation();
  const { state, blocks_read, block_count, left_out } = useParameters(({ own }) => own.table);
  return (
    <>
      {state === "reading" && (
        <Notice level="info">{t("ownGains.reading", { read: blocks_read, count: block_count })}</Notice>
      )}
      {state === "unknown" && <Notice level="info">{t("ownGains.unknown")}</Notice>}
      {left_out.length > 0 && (
        <Notice level="warning">
          {t("ownGains.leftOut")}
          <ul className="params-left-out">
            {left_out.map(({ row, name, reason }) => (
              <li key={row}>
                {t("ownGains.leftOutRow", { row, name: name ?? "" })} {t(`ownRowFault.${reason}`)}
              </li>
            ))}
          </ul>
        </Notice>
      )}
    </>
  );
}
