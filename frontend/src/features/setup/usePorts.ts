import { useCallback, useEffect, useRef, useState } from "react";
import type { Port } from "../../requests/actions";
import { ACTIONS } from "../../requests/actions";
import { usePart } from "../../store/hooks";
import type { Message } from "../../store/messages";

interface Ports {
  readonly ports: readonly Port[];
  readonly problem: Message | null;
  readonly isLoading: boolean;
  readonly refresh: () => void;
}

/** The serial ports of the gateway's computer: read when the tab opens and on request. */
export function usePorts(): Ports {
  const actions = usePart(ACTIONS);
  const [ports, setPorts] = useState<readonly Port[]>([]);
  const [problem, setProblem] = useState<Message | null>(null);
  const [isLoading, setLoading] = useState(false);
  const newest = useRef(0);

  const refresh = useCallback(() => {
    newest.current += 1;
    const mine = newest.current;
    setLoading(true);
    void actions.listPorts().then((answer) => {
      if (newest.current !== mine) {
        return; // a later request was made, or the tab is closed
      }
      setLoading(false);
      if ("key" in answer) {
        setProblem(answer);
      } else {
        setProblem(null);
        setPorts(answer);
      }
    });
  }, [actions]);

  useEffect(() => {
    refresh();
    return () => {
      newest.current += 1;
    };
  }, [refresh]);
  return { ports, problem, isLoading, refresh };
}
