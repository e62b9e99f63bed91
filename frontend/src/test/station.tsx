import { act, render } from "@testing-library/react";
import type { ReactElement } from "react";
import { I18nextProvider } from "react-i18next";
import { App } from "../app/App";
import { CATALOGUES } from "../app/catalogues";
import { loadParts } from "../app/dialogs";
import { createPage } from "../app/page";
import { SHOWN } from "../app/past";
import type { TabName } from "../app/views/views";
import type { World } from "../app/world";
import { PLAYBACK } from "../features/playback/playbackRequests";
import { createI18n } from "../i18n/i18n";
import type { Status } from "../protocol/contract";
import type { Sample } from "../protocol/envelope";
import { FIELD_KINDS } from "../protocol/topics";
import { type Page, PageContext } from "../store/hooks";
import type { BrowserStorage } from "../store/settings";
import { ManualAnimationFrames } from "./animationFrames";
import { aStatus } from "./aStatus";
import { installCanvas } from "./canvas";
import { ManualGamepads } from "./gamepads";
import { FakeReplay } from "./replay";
import { ManualSounder, ManualSpeaker } from "./sound";
import { ManualTimers, ManualWire } from "./wire";

/** A request of the page over REST, and its answer. */
export interface FakeRequest {
  readonly method: string;
  readonly path: string;
  readonly body: unknown;
  readonly answer: (value: unknown, status?: number) => Promise<void>;
}

// uPlot asks for the display's density when it is loaded.
installCanvas();
// Tests examine what is shown, not how it was loaded.
await loadParts();

const START_S = 1_700_000_000;

class MemoryStorage implements BrowserStorage {
  /** Most tests are of the tabs that were there first, beside what flies: one of them is open. */
  readonly #kept = new Map([["epf-gcs.settings", '{"choices":{"tab":"flight"}}']]);
  getItem = (key: string): string | null => this.#kept.get(key) ?? null;
  setItem = (key: string, value: string): void => {
    this.#kept.set(key, value);
  };
}

/** The whole page in a document, with gateway, clock and animation frames under the test's control. */
export class Station {
  readonly timers = new ManualTimers();
  readonly animationFrames = new ManualAnimationFrames();
  readonly sounder = new ManualSounder();
  readonly speaker = new ManualSpeaker();
  readonly gamepads = new ManualGamepads();
  readonly wires: ManualWire[] = [];
  readonly asked: FakeRequest[] = [];
  /** What the time bar asks by itself about the flight that it shows. */
  readonly askedByBar: FakeRequest[] = [];
  /** What the page asks about who may come in: also by itself, at each connection. */
  readonly askedAccess: FakeRequest[] = [];
  readonly clients: Array<string | null> = [];
  /** Streams of flights of the past, and where each was asked to begin. */
  readonly replays: FakeReplay[] = [];
  /** The address of the page. */
  url: string;
  /** Files that the page sends; each is answered as the request of its path. */
  readonly uploads: Array<{ readonly path: string; readonly onSent: (bytes: number) => void }> = [];
  /** The files that the page saved for the user. */
  readonly saved: Array<{ readonly name: string; readonly content: Blob }> = [];
  /** Exceptions in the page's own code. */
  readonly reported: unknown[] = [];
  readonly page: Page;
  #seq = 0;
  #offered: (load: () => void) => void = () => undefined;
  #moved: () => void = () => undefined;

  /** Shows the whole page, or the part of it that a test is about. */
  constructor(shown: ReactElement = <App />, url = "http://station/") {
    this.url = url;
    installCanvas();
    const world: World = {
      timers: this.timers,
      wall_ms: () => START_S * 1000 + this.timers.now_ms(),
      dial: (client, listener) => {
        const wire = new ManualWire(listener);
        this.wires.push(wire);
        this.clients.push(client);
        return wire;
      },
      dialFlight: (place, listener) => {
        const replay = new FakeReplay(place, listener);
        this.replays.push(replay);
        return replay.wire;
      },
      address: {
        read: () => this.url,
        replace: (address) => {
          this.url = address;
        },
        onMoved: (run) => (this.#moved = run),
      },
      versions: { onNewer: (hear) => (this.#offered = hear), look: () => undefined },
      fetch: (path, init) => this.#ask(path, init),
      upload: (path, { signal, onSent }) =>
        new Promise((resolve, reject) => {
          this.uploads.push({ path, onSent: (bytes) => act(() => onSent(bytes)) });
          signal.addEventListener("abort", () => reject(new TypeError("abort")));
          void this.#ask(path, { method: "POST" }).then(resolve, reject);
        }),
      animationFrames: this.animationFrames,
      storage: new MemoryStorage(),
      tabStorage: new MemoryStorage(),
      languages: ["es-ES"],
      sounder: this.sounder,
      speaker: this.speaker,
      gamepads: this.gamepads,
      report: (error) => this.reported.push(error),
      saveFile: (name, content) => this.saved.push({ name, content }),
    };
    const { page, start } = createPage(world);
    this.page = page;
    render(
      <I18nextProvider i18n={createI18n(CATALOGUES, "es")}>
        <PageContext value={page}>{shown}</PageContext>
      </I18nextProvider>,
    );
    act(start);
  }

  /** The gateway accepts the page and sends the present state. */
  greet(status: Status = aStatus()): void {
    this.deliver({
      type: "hello",
      version: "0.1.0",
      client: "c1",
      role: "operator",
      server_time_s: this.#now_s(),
      topics: [],
      status,
    });
  }

  status(status: Status): void {
    this.deliver({ type: "status", data: status });
  }

  /** Newest values of some topics, measured now; fields not given are no data. */
  send(values: Readonly<Record<string, Readonly<Record<string, number | boolean | null>>>>): void {
    const samples: Sample[] = Object.entries(values).map(([topic, known]) => ({
      topic,
      t_s: this.#now_s(),
      values: Object.fromEntries(
        (FIELD_KINDS.get(topic) ?? []).map(([field]) => [field, known[field] ?? null]),
      ),
    }));
    this.#seq += 1;
    this.deliver({ type: "batch", seq: this.#seq, t_s: this.#now_s(), samples });
  }

  /** Rows of the simulator as received, eight values each. */
  rows(rows: Readonly<Record<number, ReadonlyArray<number | null>>>): void {
    this.#seq += 1;
    const samples = [{ topic: "xplane_rows", t_s: this.#now_s(), values: { rows } }];
    this.deliver({ type: "batch", seq: this.#seq, t_s: this.#now_s(), samples });
  }

  deliver(message: unknown): void {
    act(() => this.wires.at(-1)?.deliver(message));
    this.show();
  }

  /** The stream of the flight that was opened last. */
  get replay(): FakeReplay {
    const newest = this.replays.at(-1);
    if (newest === undefined) {
      throw new Error("no flight of the past was opened");
    }
    return newest;
  }

  /** The page that the tabs read: the present one, or that of the past. */
  shown(): Page {
    return this.page.parts.get(SHOWN).getState().page;
  }

  /** Shows a moment of a flight of the past, which the gateway opens. */
  openFlight(flight: string, at_s: number): void {
    act(() => this.page.parts.get(PLAYBACK).openFlight(flight, at_s));
    this.replayed((replay) => replay.greet());
  }

  /** Let the replay answer a question. */
  async answered(about: string, data: unknown): Promise<void> {
    await act(async () => this.replay.answer(about, data));
    this.show();
  }

  /** Let the replay say something, and show it. */
  replayed(run: (replay: FakeReplay) => void): void {
    act(() => run(this.replay));
    this.show();
  }

  /** Opens a main tab, as by its address. */
  openTab(tab: TabName): void {
    this.goTo(`http://station/#tab=${tab.toLowerCase()}`);
  }

  /** Somebody writes another address into the browser's line, of which only the part behind the number sign differs. */
  goTo(url: string): void {
    this.url = url;
    act(() => this.#moved());
    this.show();
  }

  /** A newer version of the page is there. */
  offer(load: () => void): void {
    act(() => this.#offered(load));
  }

  breakOff(): void {
    act(() => this.wires.at(-1)?.breakOff());
    this.show();
  }

  /** Let time pass, with an animation frame at its end. */
  pass(duration_ms: number): void {
    act(() => this.timers.pass(duration_ms));
    this.show();
  }

  /** Two animation frames, far enough apart for texts to be painted. */
  show(): void {
    act(() => {
      this.animationFrames.show(this.timers.now_ms());
      this.timers.pass(100);
      this.animationFrames.show(this.timers.now_ms());
    });
  }

  #now_s(): number {
    return START_S + this.timers.now_ms() / 1000;
  }

  #ask(path: string, init: RequestInit): Promise<Response> {
    return new Promise((resolve) => {
      const isOfBar = /^\/api\/v1\/flights\/[^/]+\/(overview|events)/.test(path);
      const isOfAccess = path.startsWith("/api/v1/access/");
      (isOfBar ? this.askedByBar : isOfAccess ? this.askedAccess : this.asked).push({
        method: init.method ?? "GET",
        path,
        body: typeof init.body === "string" ? JSON.parse(init.body) : undefined,
        answer: async (value, status = 200) => {
          await act(async () => {
            resolve(Response.json(value, { status }));
            // The page reads the answer in steps; each needs a turn.
            await new Promise((done) => setTimeout(done, 0));
          });
          this.show();
        },
      });
    });
  }
}
