/** Without accents and capitals: what people type when they search ("alineacion" for "Alineación"). */
export function plain(text: string): string {
  return text.normalize("NFD").replace(/\p{M}/gu, "").toLowerCase();
}
