import { useEffect, useState } from "react";
import { useTranslation } from "react-i18next";
import { useSentence } from "../../i18n/useSentence";
import type { About } from "../../protocol/guards.gen";
import { usePart } from "../../store/hooks";
import type { Message } from "../../store/messages";
import { Notice } from "../../ui/Notice";
import { ABOUT } from "./aboutRequests";
import "./about.css";

interface Package {
  readonly name: string;
  readonly version: string;
  readonly licence: string | null;
}

/** Set by the build, from the lock file. */
declare const PAGE_PACKAGES: readonly Package[];

/** Versions of what is running here, and the licences of what it is made of. */
export function AboutContent() {
  const { t } = useTranslation();
  const requests = usePart(ABOUT);
  const sentence = useSentence();
  const [about, setAbout] = useState<About | Message | null>(null);
  useEffect(() => {
    let isWanted = true;
    void requests.read().then((answer) => {
      if (isWanted) {
        setAbout(answer);
      }
    });
    return () => {
      isWanted = false;
    };
  }, [requests]);
  return (
    <div className="about">
      <p>{t("about.what")}</p>
      {about !== null && !("key" in about) && <GatewayFacts about={about} />}
      {about !== null && "key" in about && <Notice level="error">{sentence(about)}</Notice>}
      <p>{t("about.licence")}</p>
      <p>
        <a href="/licences.txt" target="_blank" rel="noreferrer">
          {t("about.licenceTexts")}
        </a>
      </p>
      <Packages title={t("about.pagePackages")} packages={PAGE_PACKAGES} />
      {about !== null && !("key" in about) && (
        <Packages title={t("about.gatewayPackages")} packages={about.packages} />
      )}
    </div>
  );
}

function GatewayFacts({ about }: { about: About }) {
  const { t } = useTranslation();
  const { board } = about;
  const firmware =
    board === null
      ? t("about.noBoard")
      : t("about.board", {
          name: board.name ?? t("words.unknown"),
          version: board.version ?? t("words.unknown"),
          mode: t(`mode.${board.mode}`),
        });
  return (
    <dl className="about-facts">
      <Fact name={t("about.gateway")} value={about.version} />
      <Fact name={t("about.firmware")} value={firmware} />
      <Fact name={t("about.system")} value={`Python ${about.python}, ${about.platform}`} />
    </dl>
  );
}

function Fact({ name, value }: { name: string; value: string }) {
  return (
    <div className="about-fact">
      <dt>{name}</dt>
      <dd>{value}</dd>
    </div>
  );
}

function Packages({ title, packages }: { title: string; packages: readonly Package[] }) {
  const { t } = useTranslation();
  return (
    <table className="about-packages">
      <caption>{title}</caption>
      <thead>
        <tr>
          <th scope="col">{t("about.package")}</th>
          <th scope="col">{t("about.version")}</th>
          <th scope="col">{t("about.packageLicence")}</th>
        </tr>
      </thead>
      <tbody>
        {packages.map(({ name, version, licence }) => (
          <tr key={`${name} ${version}`}>
            <td>{name}</td>
            <td className="app-number">{version}</td>
            <td>{licence ?? t("words.unknown")}</td>
          </tr>
        ))}
      </tbody>
    </table>
  );
}
