import { screen } from "@testing-library/react";
import { expect, test } from "vitest";
import { Station } from "../../test/station";
import { Part } from "../../test/tab";
import { MapCorner } from "./MapCorner";

test("until the globe is drawn its field says that it is loaded, and has no scale", () => {
  new Station(
    <Part>
      <MapCorner />
    </Part>,
  );
  expect(screen.getByRole("status").textContent).toBe("Cargando el globo…");
  expect(screen.queryByRole("img", { name: /norte/ })).toBeNull();
});
