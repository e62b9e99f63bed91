import { ABOUT, createAbout } from "../features/about/aboutRequests";
import { ACCESS_ADMIN, createAccessAdmin } from "../features/access/accessAdmin";
import { BACKUPS, createBackups } from "../features/access/backups";
import { controlMessage } from "../features/access/controlEvents";
import { CONTROL_PAGES, createControlPages } from "../features/access/controlPages";
import { createEntry, ENTRY } from "../features/access/entry";
import { addressedTab, addressOf, takeAddressedKey } from "../features/access/keyAddress";
import { createNewVersion, NEW_VERSION } from "../features/access/newVersion";
import type { Core, Group } from "./core";
import { createFirstStart, FIRST_START } from "./firstStart/firstStart";
import { followOpenTab, openAddressedTab } from "./views/views";

/** Who may come in and who has control, whether the station is set up, and which version of the page it is. */
export interface Door extends Group {
  /** Ask anew who this page is to the gateway. */
  readonly review: () => void;
  readonly start: () => void;
}

/** `open` begins the stream of who is admitted, `shutOut` ends it. */
export function createDoor(core: Core, open: () => void, shutOut: () => void): Door {
  const { rest, timers, world, client } = core;
  const addressedKey = takeAddressedKey(world.address);
  const { entry, begin, review } = createEntry({
    rest,
    timers,
    admission: core.admission,
    addressedKey,
    isEncrypted: world.address.read().startsWith("https:"),
    start: open,
    stop: shutOut,
  });
  const newVersion = createNewVersion();
  const { firstStart, begin: beginFirstStart } = createFirstStart({
    ...core,
    connection: core.vehicle.connection,
  });
  return {
    review,
    addTo: (parts) =>
      parts
        .with(ENTRY, entry)
        .with(NEW_VERSION, newVersion)
        .with(ACCESS_ADMIN, createAccessAdmin({ ...core, address: world.address.read }))
        .with(BACKUPS, createBackups(core))
        .with(CONTROL_PAGES, createControlPages(rest, timers))
        .with(FIRST_START, firstStart)
        .with(ABOUT, createAbout(core)),
    takeEvent: (message) => {
      if (message.event === "access") {
        review();
      }
      const control = controlMessage(message, client());
      if (control !== null) {
        (control.isAnswer ? core.messages.say : core.tell)(control.message);
      }
    },
    start: () => {
      begin();
      world.versions.onNewer((load) => newVersion.setState({ load }));
      followOpenTab(core.settings, (tab) => {
        const { address } = world;
        address.replace(addressOf(address.read(), tab.toLowerCase()));
      });
      const openAddressed = (): void => openAddressedTab(core.settings, addressedTab(world.address));
      openAddressed();
      beginFirstStart();
      world.address.onMoved(openAddressed);
    },
  };
}
