import { DIALOGS } from "./dialogs/dialogs";
import { loadViews } from "./views";

/** Load every part in advance: tabs and dialogs must still open after the network is lost. */
export async function loadParts(): Promise<void> {
  await loadViews();
  for (const { load } of Object.values(DIALOGS)) {
    await load();
  }
}
