interface CookieWindow {
  readonly navigator: { readonly cookieEnabled: boolean };
  readonly document: { cookie: string };
}

const PROBE = "epf_probe";

/**
 * Whether this browser keeps the cookie by which the station knows a session. `cookieEnabled` alone does not tell:
 * Chromium says true where its user has blocked cookies for this address. So one is set, read back and deleted.
 */
export function keepsCookies({ navigator, document }: CookieWindow): boolean {
  if (!navigator.cookieEnabled) {
    return false;
  }
  document.cookie = `${PROBE}=1; Max-Age=60; Path=/; SameSite=Strict`;
  const isKept = document.cookie.split("; ").includes(`${PROBE}=1`);
  document.cookie = `${PROBE}=; Max-Age=0; Path=/; SameSite=Strict`;
  return isKept;
}
