import { DIALOGS } from "./dialogs/dialogs";
import { loadViews } from "./views";

/** Load what is not loaded yet: a station whose line is cut must still be able to open every tab and every window. */
export async function loadParts(): Promise<void> {
  await loadViews();
  for (const { load } of Object.values(DIALOGS)) {
    await load();
  }
}
