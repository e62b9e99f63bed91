import { type ReactNode, useRef } from "react";
import { Button } from "./Button";

interface Props {
  children: ReactNode;
  /** Called with the chosen file; the same file can be chosen again. */
  onFile: (file: File) => void;
  /** Suggested file types: ".json", ".kml,.gpx". */
  accept: string;
  icon?: ReactNode;
  disabledReason?: string | undefined;
}

/** A button that lets the user choose one file of this computer. */
export function FileButton({ children, onFile, accept, icon, disabledReason }: Props) {
  const input = useRef<HTMLInputElement>(null);
  return (
    <>
      <Button onPress={() => input.current?.click()} icon={icon} disabledReason={disabledReason}>
        {children}
      </Button>
      <input
        ref={input}
        type="file"
        accept={accept}
        hidden
        onChange={(event) => {
          const [file] = event.currentTarget.files ?? [];
          event.currentTarget.value = "";
          if (file !== undefined) {
            onFile(file);
          }
        }}
      />
    </>
  );
}
