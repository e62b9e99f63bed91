import { useCallback, useEffect, useState } from "react";
import { useTranslation } from "react-i18next";
import { useSentence } from "../../i18n/useSentence";
import { formatDateTime } from "../../lib/moment";
import type { DeedState } from "../../protocol/guards.gen";
import type { Message } from "../../store/messages";
import { Button } from "../../ui/Button";
import { Notice } from "../../ui/Notice";
import { TextField } from "../../ui/TextField";
import { LOG_LINES } from "./accessAdmin";
import { deedResult, deedWords } from "./deedWords";
import { Rows } from "./People";
import { useAccessAdmin } from "./useAccessLists";

/** What people did, newest first, with a search. Nothing here can change it. */
export function AccessLog() {
  const { t } = useTranslation();
  const sentence = useSentence();
  const { readLog } = useAccessAdmin();
  const [text, setText] = useState("");
  const [deeds, setDeeds] = useState<readonly DeedState[] | null>(null);
  const [hasMore, setMore] = useState(false);
  const [failure, setFailure] = useState<Message | null>(null);

  const read = useCallback(
    async (before: readonly DeedState[]): Promise<void> => {
      const answer = await readLog(text, before.at(-1)?.at ?? null);
      if ("deeds" in answer) {
        setDeeds([...before, ...answer.deeds]);
        setMore(answer.deeds.length === LOG_LINES);
        setFailure(null);
      } else {
        setFailure(answer);
      }
    },
    [readLog, text],
  );
  useEffect(() => void read([]), [read]);

  return (
    <div className="access-section">
      <TextField label={t("access.filter")} value={text} onCommit={setText} />
      {failure !== null && <Notice level="error">{sentence(failure)}</Notice>}
      {deeds?.length === 0 && <p>{t("access.noDeeds")}</p>}
      {deeds !== null && deeds.length > 0 && (
        <Rows
          head={[
            t("access.time"),
            t("access.deedWho"),
            t("access.from"),
            t("access.deedWhat"),
            t("access.deedResult"),
          ]}
        >
          {deeds.map((deed) => (
            <Deed key={deed.at} deed={deed} />
          ))}
        </Rows>
      )}
      {hasMore && <Button onPress={() => void read(deeds ?? [])}>{t("access.older")}</Button>}
    </div>
  );
}

function Deed({
  deed: { t_s, name, kind, role, address, deed, what, result },
}: {
  readonly deed: DeedState;
}) {
  const { t } = useTranslation();
  const sentence = useSentence();
  const who = kind === "local" ? t("control.station") : kind === "stranger" ? t("access.stranger") : name;
  const did = sentence({ level: "info", key: `deed.${deed}`, params: {}, fallback: deed });
  const named = deedWords(t, deed, what);
  return (
    <tr>
      <td>{formatDateTime(t_s)}</td>
      <td className="access-who">
        {role === null || kind === "local" ? who : `${who} (${t(`role.${role}`)})`}
      </td>
      <td>{address}</td>
      <td className="access-what">{named === "" ? did : `${did}: ${named}`}</td>
      <td className="access-who">
        {sentence({
          level: "info",
          key: `deedResult.${result}`,
          params: {},
          fallback: deedResult(t, result),
        })}
      </td>
    </tr>
  );
}
