import { expect, test } from "vitest";
import { addressedTab, addressOf, isOfThisComputerAlone, readKey, takeAddressedKey } from "./keyAddress";

function take(address: string): { key: string | null; left: string } {
  let now = address;
  const key = takeAddressedKey({
    read: () => now,
    replace: (next) => {
      now = next;
    },
  });
  return { key, left: now };
}

test("the key leaves the address bar when it is taken, and what else the address says stays", () => {
  expect(take("http://station:8000/?flight=current&at=3.00#key=7K2Q-AAAA-BBBB-CCCC&tab=map")).toEqual({
    key: "7K2Q-AAAA-BBBB-CCCC",
    left: "http://station:8000/?flight=current&at=3.00#tab=map",
  });
});

test("the tab that an address names stays in it", () => {
  const read = (address: string) => addressedTab({ read: () => address });
  expect(read("http://station:8000/#tab=map")).toBe("map");
  expect(read("http://station:8000/#other=1")).toBeNull();
});

test("an address without a key is left as it is", () => {
  expect(take("http://station:8000/")).toEqual({ key: null, left: "http://station:8000/" });
  expect(take("http://station:8000/#other=1").left).toBe("http://station:8000/#other=1");
});

test("an empty key is no key, and is removed all the same", () => {
  expect(take("http://station:8000/#key=")).toEqual({ key: null, left: "http://station:8000/" });
});

test("a key is read as people write it: small letters, without hyphens, O for zero, I and L for one", () => {
  expect(readKey(" 7k2q aaaa-bbbb olic ")).toBe("7K2Q-AAAA-BBBB-011C");
  expect(readKey("")).toBe("");
});

test("the address of a tab keeps the key of an invitation", () => {
  expect(addressOf("https://station:8000/#key=7K2Q-A", "map")).toBe(
    "https://station:8000/#key=7K2Q-A&tab=map",
  );
  expect(addressOf("http://station:8000/?flight=current", "plots")).toBe(
    "http://station:8000/?flight=current#tab=plots",
  );
});

test("an address of this computer alone is known, whichever way it is written", () => {
  for (const host of ["localhost", "127.0.0.1", "127.3.2.1", "[::1]", "gcs.localhost"]) {
    expect(isOfThisComputerAlone(`http://${host}:8000/#tab=map`), host).toBe(true);
  }
  for (const host of ["station", "10.0.0.7", "[fe80::1]", "128.0.0.1", "localhost.example"]) {
    expect(isOfThisComputerAlone(`https://${host}:8000/`), host).toBe(false);
  }
});
