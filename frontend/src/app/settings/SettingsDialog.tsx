import type { ReactNode } from "react";
import { useTranslation } from "react-i18next";
import { AS_SENT, chooseUnit, QUANTITIES, type Quantity, unitChoice, unitsOf } from "../../store/chosenUnits";
import { usePage, useSettings } from "../../store/hooks";
import { choose, LANGUAGES } from "../../store/settings";
import { THEMES } from "../../theme/theme";
import { SegmentedSwitch } from "../../ui/SegmentedSwitch";
import { areKeysOn, chooseKeys, MOTION, motionOf } from "./choices";
import "../views/dialogs.css";

/** The settings that this browser remembers, by section. Every change applies at once. */
export function SettingsContent() {
  const { t } = useTranslation();
  return (
    <div className="settings">
      <Section title={t("settings.look")}>
        <Language />
        <Theme />
        <Motion />
      </Section>
      <Section title={t("settings.keyboard")}>
        <Keys />
      </Section>
      <Section title={t("settings.units")}>
        <p className="settings-hint">{t("settings.unitsHint")}</p>
        {QUANTITIES.map((quantity) => (
          <UnitSwitch key={quantity} quantity={quantity} />
        ))}
      </Section>
    </div>
  );
}

function Section({ title, children }: { title: string; children: ReactNode }) {
  return (
    <section className="settings-section" aria-label={title}>
      <h3>{title}</h3>
      {children}
    </section>
  );
}

function Language() {
  const { t } = useTranslation();
  const { settings } = usePage();
  return (
    <SegmentedSwitch
      label={t("app.language")}
      options={LANGUAGES.map((value) => ({ value, label: t(`language.${value}`) }))}
      value={useSettings(({ language }) => language)}
      onChange={(language) => settings.setState({ language })}
    />
  );
}

function Theme() {
  const { t } = useTranslation();
  const { settings } = usePage();
  return (
    <SegmentedSwitch
      label={t("app.theme")}
      options={THEMES.map((value) => ({ value, label: t(`theme.${value}`) }))}
      value={useSettings(({ theme }) => theme)}
      onChange={(theme) => settings.setState({ theme })}
    />
  );
}

function Motion() {
  const { t } = useTranslation();
  const { settings } = usePage();
  return (
    <SegmentedSwitch
      label={t("settings.motion")}
      options={MOTION.map((value) => ({ value, label: t(`motion.${value}`) }))}
      value={useSettings(motionOf)}
      onChange={(motion) => choose(settings, "motion", motion)}
    />
  );
}

function Keys() {
  const { t } = useTranslation();
  const { settings } = usePage();
  const isOn = useSettings(areKeysOn);
  return (
    <SegmentedSwitch
      label={t("settings.keys")}
      options={[
        { value: "on", label: t("words.on") },
        { value: "off", label: t("words.off") },
      ]}
      value={isOn ? "on" : "off"}
      onChange={(value) => chooseKeys(settings, value === "on")}
    />
  );
}

function UnitSwitch({ quantity }: { quantity: Quantity }) {
  const { t } = useTranslation();
  const { settings } = usePage();
  return (
    <SegmentedSwitch
      label={t(`quantity.${quantity}`)}
      options={[
        { value: AS_SENT, label: t("settings.asSent") },
        ...unitsOf(quantity).map((unit) => ({ value: unit, label: t(`unit.${unit}`) })),
      ]}
      value={useSettings((chosen) => unitChoice(chosen, quantity))}
      onChange={(unit) => chooseUnit(settings, quantity, unit)}
    />
  );
}
