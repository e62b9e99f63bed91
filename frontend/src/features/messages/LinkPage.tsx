import { useEffect, useRef } from "react";
import { useTranslation } from "react-i18next";
import { formatFixed } from "../../lib/format";
import type { Inspection } from "../../protocol/contract";
import { Meter, type MeterHandle } from "../../ui/Meter";

type Link = Inspection["link"];

/** The load of both links against their capacity, and the delay of the HIL loop. */
export function LinkPage({ link }: { link: Link }) {
  const { t } = useTranslation();
  const { newest, p50, p99 } = link.round_trip_ms;
  const capacity = link.capacity_bytes_per_s;
  const ms = (value: number | null): string => {
    const text = formatFixed(value, 1);
    return text === null ? t("words.dash") : `${text} ${t("unit.ms")}`;
  };
  return (
    <div className="messages-link">
      <Load
        label={t("messages.rx")}
        percent={link.rx_percent}
        bytes_per_s={link.rx_bytes_per_s}
        capacity_bytes_per_s={capacity}
      />
      <Load
        label={t("messages.tx")}
        percent={link.tx_percent}
        bytes_per_s={link.tx_bytes_per_s}
        capacity_bytes_per_s={capacity}
      />
      <Load
        label={t("messages.simulatorLoad")}
        percent={link.simulator_percent}
        bytes_per_s={link.simulator_bytes_per_s}
        capacity_bytes_per_s={null}
      />
      <h3 className="messages-heading">{t("messages.roundTrip")}</h3>
      {link.round_trips === null && <p className="messages-well">{t("messages.notRecorded")}</p>}
      <dl className="messages-facts">
        <dt>{t("messages.newest")}</dt>
        <dd>{ms(newest)}</dd>
        <dt>{t("messages.p50")}</dt>
        <dd>{ms(p50)}</dd>
        <dt>{t("messages.p99")}</dt>
        <dd>{ms(p99)}</dd>
        <dt>{t("messages.roundTrips")}</dt>
        <dd>{link.round_trips ?? t("words.dash")}</dd>
      </dl>
    </div>
  );
}

interface LoadProps {
  label: string;
  percent: number | null;
  bytes_per_s: number;
  capacity_bytes_per_s: number | null;
}

function Load({ label, percent, bytes_per_s, capacity_bytes_per_s }: LoadProps) {
  const { t } = useTranslation();
  const meter = useRef<MeterHandle>(null);
  const rate = String(Math.round(bytes_per_s));
  const text =
    capacity_bytes_per_s === null
      ? t("messages.bytes", { rate })
      : t("messages.bytesOf", { rate, capacity: Math.round(capacity_bytes_per_s) });
  const share = percent === null ? t("words.dash") : `${formatFixed(percent, 0) ?? ""} ${t("unit.percent")}`;
  useEffect(() => {
    meter.current?.paint(percent, share);
  }, [percent, share]);
  return (
    <div className="messages-load">
      <Meter ref={meter} label={label} />
      <span className="messages-load-text">{text}</span>
    </div>
  );
}
