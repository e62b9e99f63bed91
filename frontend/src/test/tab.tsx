import { Fragment, type ReactNode } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { Shared } from "../app/App";
import { PresentPage } from "../app/bars/presentPage";
import { DialogsProvider } from "../app/dialogs";
import { View } from "../app/MainTabs";
import { SHOWN } from "../app/past";
import type { TabName } from "../app/views/views";
import { PageContext, usePage, usePart } from "../store/hooks";

/** A part of the window without the window: it reads the page that is shown, and may open dialogs. */
export function Part({ children }: { children: ReactNode }) {
  const present = usePage();
  const shown = useStore(usePart(SHOWN), ({ page }) => page);
  return (
    <Shared>
      <PageContext value={shown}>
        <PresentPage value={present}>
          <DialogsProvider>
            <Fragment key={shown.key}>{children}</Fragment>
          </DialogsProvider>
        </PresentPage>
      </PageContext>
    </Shared>
  );
}

/** One tab without the window. */
export function Tab({ name }: { name: TabName }) {
  const { t } = useTranslation();
  return (
    <Part>
      <main role="tabpanel" aria-label={t(`tab.${name}`)}>
        <View tab={name} />
      </main>
    </Part>
  );
}
