import { Component, type ComponentType, type ReactNode, Suspense, use } from "react";

/** A part of the page that is loaded on first use, or in advance. */
export interface LazyPart {
  readonly Part: ComponentType<{ waiting: ReactNode; failed: (retry: () => void) => ReactNode }>;
  /** Load it now; a failure is handled by the part, which tries again when it is shown. */
  readonly load: () => Promise<void>;
}

/** Once loaded it is rendered at once, without suspending. */
export function lazyPart(load: () => Promise<ComponentType>): LazyPart {
  let loading: Promise<ComponentType> | null = null;

  function start(): Promise<ComponentType> {
    if (loading === null) {
      const started = load();
      loading = started;
      // React reads these two properties, and does not suspend on a promise that has them.
      started.then(
        (value) => Object.assign(started, { status: "fulfilled", value }),
        () => undefined,
      );
    }
    return loading;
  }

  function Content(): ReactNode {
    const Loaded = use(start());
    return <Loaded />;
  }

  return {
    Part: ({ waiting, failed }) => (
      <Boundary
        failed={failed}
        onRetry={() => {
          loading = null;
        }}
      >
        <Suspense fallback={waiting}>
          <Content />
        </Suspense>
      </Boundary>
    ),
    load: async () => {
      try {
        await start();
      } catch {
        loading = null;
      }
    },
  };
}

interface BoundaryProps {
  failed: (retry: () => void) => ReactNode;
  onRetry: () => void;
  children: ReactNode;
}

/** Replaces a part that could not be loaded or that threw: the rest of the page goes on. */
class Boundary extends Component<BoundaryProps, { hasFailed: boolean }> {
  override state = { hasFailed: false };

  static getDerivedStateFromError(): { hasFailed: boolean } {
    return { hasFailed: true };
  }

  readonly #retry = (): void => {
    this.props.onRetry();
    this.setState({ hasFailed: false });
  };

  override render(): ReactNode {
    return this.state.hasFailed ? this.props.failed(this.#retry) : this.props.children;
  }
}
