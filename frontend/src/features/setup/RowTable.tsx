import { useCallback, useRef } from "react";
import { useTranslation } from "react-i18next";
import { formatAge, formatMeasured, WIRE_FIGURES } from "../../lib/format";
import { XPLANE_ROWS } from "../../protocol/messages.gen";
import { useTelemetry } from "../../store/hooks";
import type { TelemetryStore } from "../../store/telemetry";
import { usePaint } from "../../store/usePaint";
import { Panel } from "../../ui/Panel";
import { SteadyText, type SteadyTextHandle } from "../../ui/SteadyText";

const VALUES = [0, 1, 2, 3, 4, 5, 6, 7] as const;

/** Every row that X-Plane sent, live: its number and its eight values. */
export function RowTable() {
  const { t } = useTranslation();
  // Joined as text, so that React renders only when a row appears or falls silent.
  const heard = useTelemetry((telemetry) => [...telemetry.rows.keys()].sort((a, b) => a - b).join());
  const live = useTelemetry(
    (telemetry, now_ms) =>
      [...telemetry.rows.keys()].filter((row) => telemetry.rowState(row, now_ms) === "live").length,
  );
  const rows = heard === "" ? [] : heard.split(",").map(Number);
  return (
    <Panel title={t("rowTable.title", { number: live })} className="setup-rows">
      {rows.length === 0 ? (
        <p className="setup-log-empty">{t("rowTable.none")}</p>
      ) : (
        <section
          className="setup-rows-scroll"
          aria-label={t("rowTable.label")}
          // biome-ignore lint/a11y/noNoninteractiveTabindex: the keyboard must be able to scroll it
          tabIndex={0}
        >
          <table className="setup-table">
            <thead>
              <tr>
                <th scope="col">{t("rowTable.row")}</th>
                <th scope="col">{t("rowTable.name")}</th>
                {VALUES.map((index) => (
                  <th key={index} scope="col" className="setup-table-number">
                    {index}
                  </th>
                ))}
                <th scope="col" className="setup-table-number">
                  {t("rowTable.age")}
                </th>
              </tr>
            </thead>
            <tbody>
              {rows.map((row) => (
                <Row key={row} row={row} />
              ))}
            </tbody>
          </table>
        </section>
      )}
    </Panel>
  );
}

/** One row, painted without a render; a stale or missing value is shown as no data. */
function Row({ row }: { row: number }) {
  const { t } = useTranslation();
  const name = useRowName(row);
  const dash = t("words.dash");
  const line = useRef<HTMLTableRowElement>(null);
  const cells = useRef<Array<SteadyTextHandle | null>>([]);
  const age = useRef<SteadyTextHandle>(null);
  const paint = useCallback(
    (telemetry: TelemetryStore, now_ms: number) => {
      for (const index of VALUES) {
        const value = telemetry.liveRowValue(row, index, now_ms);
        cells.current[index]?.write(formatMeasured(value, WIRE_FIGURES) ?? dash);
      }
      const age_s = telemetry.rowAge_s(row, now_ms);
      age.current?.write(age_s === null ? dash : formatAge(age_s));
      if (line.current !== null) {
        line.current.dataset["state"] = telemetry.rowState(row, now_ms);
      }
    },
    [row, dash],
  );
  usePaint("text", paint);
  return (
    <tr ref={line}>
      <th scope="row" className="setup-table-row">
        {row}
      </th>
      <td>{name}</td>
      {VALUES.map((index) => (
        <td key={index} className="setup-table-number">
          <SteadyText
            ref={(cell) => {
              cells.current[index] = cell;
            }}
            chars={9}
          />
        </td>
      ))}
      <td className="setup-table-number setup-table-age">
        <SteadyText ref={age} chars={6} />
      </td>
    </tr>
  );
}

/** Names of X-Plane's rows by number; an unknown row has none. */
const NAMES = new Map(XPLANE_ROWS.xp10.map(({ id, name }) => [id, name]));

export function useRowName(row: number): string {
  const { t, i18n } = useTranslation();
  const name = NAMES.get(row);
  const key = `simulatorRow.${name}`;
  return name !== undefined && i18n.exists(key) ? t(key as "simulatorRow.speeds") : t("words.dash");
}
