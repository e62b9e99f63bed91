import { ChevronLeft, ChevronRight, FileDown, Image, ListTree, Plus, ZoomIn, ZoomOut } from "lucide-react";
import { type RefObject, useCallback, useLayoutEffect, useMemo, useRef, useState } from "react";
import { useTranslation } from "react-i18next";
import { useSentence } from "../../i18n/useSentence";
import { usePage, usePart, useSettings } from "../../store/hooks";
import { choose } from "../../store/settings";
import { Button } from "../../ui/Button";
import { Notice } from "../../ui/Notice";
import { CompareControls, flightName, useFlights } from "./CompareControls";
import type { ChartListener } from "./chartGestures";
import { LayoutControls } from "./LayoutControls";
import { type PaneHandle, PlotPane } from "./PlotPane";
import { MOST_PANES, movedPane, type Panes, withoutPane, withoutSignal, withSignal } from "./plotLayouts";
import { PLOTS } from "./plots";
import { ALL, between, LAST, panned, type Stretch, stretchOf, zoomed } from "./plotView";
import { SignalPicker } from "./SignalPicker";
import { edgeOf, useAsking } from "./useAsking";
import { useFeed, usePanes, usePlotsState, useSubject } from "./usePlots";
import { useSaving } from "./useSaving";
import "./plots.css";

const ZOOM_STEP = 2;
const PAN_SHARE = 0.25;

/** Any signals of the shown flight in linked plots. */
export function PlotsView() {
  const { t } = useTranslation();
  const { settings } = usePage();
  const { store } = usePart(PLOTS);
  const [panes, setPanes] = usePanes();
  const active = Math.min(
    usePlotsState((state) => state.active),
    panes.length - 1,
  );
  const compared = usePlotsState((state) => state.compared);
  const isPicking = useSettings(({ choices }) => choices["plots.picker"] !== "closed");
  const subject = useSubject();
  const flights = useFlights(subject);
  const body = useRef<HTMLDivElement>(null);
  const charts = useRef(new Map<number, PaneHandle>());
  const listener = useListener();
  useAsking(subject, panes, usePoints(body));
  const otherName = compared === null ? null : flightName(flights, compared);
  const { saveCsv, savePng, isPngFailed } = useSaving(charts, subject, otherName);

  function change(next: Panes, chosen = active): void {
    setPanes(next);
    store.setState({ active: Math.min(chosen, next.length - 1) });
  }

  return (
    <div className="plots">
      <div className="plots-bar" role="toolbar" aria-label={t("plots.title")}>
        <LayoutControls panes={panes} onPanes={(next) => change(next, 0)} />
        <ViewControls listener={listener} />
        <CompareControls subject={subject} flights={flights} />
        <span className="plots-gap" />
        <Button
          onPress={() => choose(settings, "plots.picker", isPicking ? "closed" : "open")}
          pressed={isPicking}
          icon={<ListTree aria-hidden="true" size={14} />}
        >
          {t("plots.signals")}
        </Button>
        <Button
          onPress={() => change([...panes, []], panes.length)}
          disabledReason={
            panes.length >= MOST_PANES ? t("plots.fullPanes", { count: MOST_PANES }) : undefined
          }
          icon={<Plus aria-hidden="true" size={14} />}
        >
          {t("plots.addPane")}
        </Button>
        <Button
          onPress={saveCsv}
          label={t("plots.csvLabel")}
          icon={<FileDown aria-hidden="true" size={14} />}
        >
          {t("plots.csv")}
        </Button>
        <Button onPress={savePng} label={t("plots.pngLabel")} icon={<Image aria-hidden="true" size={14} />}>
          {t("plots.png")}
        </Button>
      </div>
      {isPngFailed && <Notice level="error">{t("plots.pngFailed")}</Notice>}
      <Condition subject={subject} />
      <div className="plots-body" data-picking={isPicking}>
        {isPicking && (
          <SignalPicker
            chosen={panes[active] ?? []}
            onAdd={(name) => change(withSignal(panes, active, name))}
          />
        )}
        <div ref={body} className="plots-panes">
          {panes.map((signals, index) => (
            <PlotPane
              // biome-ignore lint/suspicious/noArrayIndexKey: a pane is its place; what it draws follows its signals
              key={index}
              number={index + 1}
              count={panes.length}
              signals={signals}
              isActive={index === active}
              listener={listener}
              charts={charts}
              otherName={otherName}
              onChoose={() => store.setState({ active: index })}
              onMove={(by) => change(movedPane(panes, index, by), index + by)}
              onRemove={() => change(withoutPane(panes, index))}
              onRemoveSignal={(name) => change(withoutSignal(panes, index, name))}
            />
          ))}
        </div>
      </div>
    </div>
  );
}

/** What hinders the plots: no flight, a question under way, one that failed. */
function Condition({ subject }: { readonly subject: string | null }) {
  const { t } = useTranslation();
  const sentence = useSentence();
  const plots = usePart(PLOTS);
  const failure = useFeed("feed", (state) => state.failure);
  const otherFailure = useFeed("other", (state) => state.failure);
  const isWaiting = useFeed("feed", (state) => state.isLoading && state.signals.size === 0);
  const isOtherWaiting = useFeed("other", (state) => state.isLoading && state.signals.size === 0);
  if (subject === null) {
    return <Notice level="info">{t("plots.noFlight")}</Notice>;
  }
  const why = failure ?? otherFailure;
  if (why !== null) {
    return (
      <Notice level="error">
        {t("plots.failed", { why: sentence(why) })}{" "}
        <Button onPress={(failure === null ? plots.other : plots.feed).retry}>{t("plots.retry")}</Button>
      </Notice>
    );
  }
  return isWaiting || isOtherWaiting ? (
    <div className="plots-waiting" role="status">
      <progress aria-label={t("plots.loading")} />
      <span>{t("plots.loading")}</span>
    </div>
  ) : null;
}

/** Zoom and move without a mouse. */
function ViewControls({ listener }: { readonly listener: Listener }) {
  const { t } = useTranslation();
  const { store } = usePart(PLOTS);
  const kind = usePlotsState((state) => state.view.kind);
  return (
    <>
      <Button
        onPress={() => listener.onStep(1 / ZOOM_STEP, 0)}
        label={t("plots.zoomIn")}
        icon={<ZoomIn aria-hidden="true" size={14} />}
      >
        {null}
      </Button>
      <Button
        onPress={() => listener.onStep(ZOOM_STEP, 0)}
        label={t("plots.zoomOut")}
        icon={<ZoomOut aria-hidden="true" size={14} />}
      >
        {null}
      </Button>
      <Button
        onPress={() => listener.onStep(1, -PAN_SHARE)}
        label={t("plots.earlier")}
        icon={<ChevronLeft aria-hidden="true" size={14} />}
      >
        {null}
      </Button>
      <Button
        onPress={() => listener.onStep(1, PAN_SHARE)}
        label={t("plots.later")}
        icon={<ChevronRight aria-hidden="true" size={14} />}
      >
        {null}
      </Button>
      <Button onPress={listener.onAll} pressed={kind === "all"}>
        {t("plots.all")}
      </Button>
      <Button onPress={() => store.setState({ view: LAST })} pressed={kind === "last"}>
        {t("plots.last")}
      </Button>
    </>
  );
}

type Listener = Omit<ChartListener, "onHover"> & {
  /** Zoom about the middle, or move by a share of what is shown. */
  readonly onStep: (factor: number, share: number) => void;
};

/** What zooming, moving and clicking do to the view and the moment. */
function useListener(): Listener {
  const plots = usePart(PLOTS);
  const { telemetry, pump } = usePage();
  return useMemo(() => {
    const now = (): { edge_s: number; stretch: Stretch } => {
      const edge_s = edgeOf(plots, telemetry, pump.now_ms);
      return { edge_s, stretch: stretchOf(plots.store.getState().view, edge_s) };
    };
    const move = (by_s: number): void => {
      const { edge_s, stretch } = now();
      plots.store.setState({ view: panned(stretch, by_s, edge_s) });
    };
    const zoom = (about_s: number, factor: number): void => {
      const { edge_s, stretch } = now();
      plots.store.setState({ view: zoomed(stretch, about_s, factor, edge_s) });
    };
    return {
      onZoomTo: (from_s, to_s) => {
        plots.store.setState({ view: between(from_s, to_s, now().edge_s) });
      },
      onZoom: zoom,
      onPan: move,
      onAll: () => plots.store.setState({ view: ALL }),
      onMoment: (at_s) => {
        const { stretch } = now();
        // What runs along with the present would leave the moment that was chosen.
        if (plots.store.getState().view.kind === "last") {
          plots.store.setState({ view: { kind: "stretch", ...stretch } });
        }
        plots.timeline.seek(at_s);
      },
      onStep: (factor, share) => {
        const { stretch } = now();
        const span_s = stretch.to_s - stretch.from_s;
        if (share === 0) {
          zoom(stretch.from_s + span_s / 2, factor);
        } else {
          move(share * span_s);
        }
      },
    };
  }, [plots, telemetry, pump]);
}

const LEAST_POINTS = 300;
const MOST_POINTS = 4000;
const USUAL_POINTS = 1000;

/** As many steps as the plots have pixels, to the next hundred, so that a small change asks nothing anew. */
function usePoints(body: RefObject<HTMLElement | null>): number {
  const [points, setPoints] = useState(USUAL_POINTS);
  const measure = useCallback(() => {
    const width = body.current?.clientWidth ?? 0;
    setPoints(
      width === 0
        ? USUAL_POINTS
        : Math.min(MOST_POINTS, Math.max(LEAST_POINTS, Math.ceil(width / 100) * 100)),
    );
  }, [body]);
  useLayoutEffect(() => {
    measure();
    const resized = new ResizeObserver(measure);
    if (body.current !== null) {
      resized.observe(body.current);
    }
    return () => resized.disconnect();
  }, [body, measure]);
  return points;
}
