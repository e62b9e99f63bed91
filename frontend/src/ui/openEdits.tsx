import {
  createContext,
  type ReactNode,
  useContext,
  useEffect,
  useId,
  useState,
  useSyncExternalStore,
} from "react";
import { useWords } from "./words";

/** The fields of one form whose last edit was refused or is asked about, by their names. */
class OpenEdits {
  readonly #names = new Map<string, string>();
  readonly #listeners = new Set<() => void>();

  readonly subscribe = (listener: () => void): (() => void) => {
    this.#listeners.add(listener);
    return () => this.#listeners.delete(listener);
  };

  /** The name of the first; undefined if there is none. */
  readonly first = (): string | undefined => this.#names.values().next().value;

  /** Returns what takes it away again. */
  add(id: string, name: string): () => void {
    this.#names.set(id, name);
    this.#tell();
    return () => {
      this.#names.delete(id);
      this.#tell();
    };
  }

  #tell(): void {
    for (const listener of this.#listeners) listener();
  }
}

/** Outside a form no button waits for a field. */
const OpenEditsContext = createContext<OpenEdits | null>(null);

/** A form: buttons in it that act on its fields wait until each edit was taken or given up. */
export function EditScope({ children }: { children: ReactNode }) {
  const [edits] = useState(() => new OpenEdits());
  return <OpenEditsContext value={edits}>{children}</OpenEditsContext>;
}

/** Says to the form around a field whether the field's last edit is open. */
export function useOpenEdit(name: string, isOpen: boolean): void {
  const edits = useContext(OpenEditsContext);
  const id = useId();
  useEffect(() => (isOpen ? edits?.add(id, name) : undefined), [edits, id, name, isOpen]);
}

/** Why a button cannot act on the fields of its form now; undefined if it can. */
export function useEditsBlocked(): string | undefined {
  const edits = useContext(OpenEditsContext);
  const words = useWords();
  const name = useSyncExternalStore(edits?.subscribe ?? never, edits?.first ?? nothing);
  return name === undefined ? undefined : words.openEdit(name);
}

function never(): () => void {
  return nothing;
}

function nothing(): undefined {
  return undefined;
}
