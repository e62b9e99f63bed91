import { useEffect } from "react";
import { FIELD_WISH } from "../../store/fieldWish";
import { usePart } from "../../store/hooks";
import { useDialogs } from "./useDialogs";

/** Opens the window of fields when the map asks for it. */
export function FieldWished() {
  const wishes = usePart(FIELD_WISH);
  const { open } = useDialogs();
  useEffect(() => wishes.subscribe(({ wish }) => wish !== null && open("field")), [wishes, open]);
  return null;
}
