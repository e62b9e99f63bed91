import { act, screen, within } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { expect, test } from "vitest";
import { Station } from "../../test/station";
import { GuideContent } from "./GuideContent";

test("the guide opens at its first chapter, turns to another by keyboard, and follows the language", async () => {
  const station = new Station(<GuideContent />);
  const user = userEvent.setup();
  const article = () => screen.getByRole("article");
  expect(within(article()).getByRole("heading", { level: 3 }).textContent).toBe("Empezar");
  await user.tab();
  await user.tab();
  await user.keyboard("{Enter}");
  expect(within(article()).getByRole("heading", { level: 3 }).textContent).toBe("Conectar una placa");
  expect(within(article()).getByRole("img", { name: "La pestaña Setup" }).getAttribute("src")).toBe(
    "/guide/es/setup.webp",
  );
  act(() => station.page.settings.setState({ language: "en" }));
  expect(within(article()).getByRole("heading", { level: 3 }).textContent).toBe("Connecting a board");
  expect(station.asked).toEqual([]);
});
