import { expect, test } from "vitest";
import { isText, list, shape } from "../lib/check";
import { Rest } from "./rest";

const isNamed = shape({ name: isText });

interface RequestCopy {
  path: string;
  init: RequestInit;
}

function restThat(answer: () => Response | Promise<Response>, client: string | null = "c1") {
  const sent: RequestCopy[] = [];
  const fetch = async (path: string, init: RequestInit): Promise<Response> => {
    sent.push({ path, init });
    return answer();
  };
  const rest = new Rest({
    client: () => client,
    fetch,
    upload: async (path, { headers, body, onSent }) => {
      onSent(body.size);
      return fetch(path, { headers, body });
    },
  });
  return { rest, sent };
}

test("a question carries the page's name and its body", async () => {
  const { rest, sent } = restThat(() => Response.json({ name: "x" }));
  const answer = await rest.ask("PUT", "/api/v1/hil", isNamed, { path: "manual" });
  expect(answer).toEqual({ ok: true, value: { name: "x" } });
  expect(sent[0]?.init).toMatchObject({
    method: "PUT",
    body: '{"path":"manual"}',
    headers: { "x-client": "c1", "content-type": "application/json" },
  });
});

test("before the stream gave a name the question has none", async () => {
  const { rest, sent } = restThat(() => Response.json({ name: "x" }), null);
  await rest.ask("GET", "/api/v1/ports", isNamed);
  expect(sent[0]?.init.headers).not.toHaveProperty("x-client");
});

test("a problem document keeps its code, its sentence and the values in it", async () => {
  const { rest } = restThat(() =>
    Response.json(
      {
        status: 409,
        code: "link_busy",
        detail: "It is in use.",
        params: { target: "/dev/ttyUSB0" },
      },
      { status: 409 },
    ),
  );
  expect(await rest.ask("PUT", "/x", isNamed, {})).toEqual({
    ok: false,
    problem: { code: "link_busy", detail: "It is in use.", params: { target: "/dev/ttyUSB0" } },
  });
});

test("a failure that is no problem document says its status", async () => {
  const { rest } = restThat(() => new Response("<html>Bad Gateway</html>", { status: 502 }));
  const answer = await rest.ask("GET", "/x", isNamed);
  expect(answer).toMatchObject({ ok: false, problem: { code: "unexpected", params: { status: 502 } } });
});

test("a gateway that is not there is a problem and no exception", async () => {
  const { rest } = restThat(() => Promise.reject(new TypeError("failed to fetch")));
  expect(await rest.ask("GET", "/x", isNamed)).toMatchObject({
    ok: false,
    problem: { code: "gateway_unreachable" },
  });
});

test("an answer of which a part does not fit is a problem that says which part", async () => {
  const isFleet = shape({ planes: list(isNamed) });
  const { rest } = restThat(() => Response.json({ planes: [{ name: "x" }, { name: 7 }] }));
  expect(await rest.ask("GET", "/x", isFleet)).toEqual({
    ok: false,
    problem: {
      code: "answer_misfit",
      detail: "The gateway's answer is not as agreed at planes[1].name: load the page again.",
      params: { field: "planes[1].name" },
    },
  });
});

test.each(["[7]", "not JSON", ""])("an answer that is not as agreed (%s) is a problem", async (text) => {
  const { rest } = restThat(() => new Response(text));
  expect(await rest.ask("GET", "/x", isNamed)).toMatchObject({
    ok: false,
    problem: { code: "answer_unreadable" },
  });
});

test("an answer that breaks off is a gateway that is not there", async () => {
  const { rest } = restThat(
    () =>
      new Response(
        new ReadableStream({
          start: (controller) => controller.error(new TypeError("network error")),
        }),
      ),
  );
  expect(await rest.ask("GET", "/x", isNamed)).toMatchObject({ problem: { code: "gateway_unreachable" } });
  expect(await rest.file("/x", {})).toMatchObject({ problem: { code: "gateway_unreachable" } });
});

test.each([
  ["PUT", "/api/v1/alarms/thresholds"],
  ["POST", "/api/v1/alarms/battery_low/acknowledge"],
] as const)("a question that a change (%s %s) overtook is asked again", async (method, path) => {
  const answers: ((name: string) => void)[] = [];
  const { rest, sent } = restThat(
    () =>
      new Promise((resolve) => {
        answers.push((name) => resolve(Response.json({ name })));
      }),
  );
  const asked = rest.ask("GET", "/api/v1/alarms/thresholds?of=all", isNamed);
  const changed = rest.ask(method, path, isNamed, {});
  answers[1]?.("changed");
  await changed;
  answers[0]?.("before");
  await expect.poll(() => sent.length).toBe(3);
  answers[2]?.("now");
  expect(await asked).toEqual({ ok: true, value: { name: "now" } });
});

test("a question is asked once when what changed is something else", async () => {
  const { rest, sent } = restThat(() => Response.json({ name: "x" }));
  const asked = rest.ask("GET", "/api/v1/ports", isNamed);
  await rest.ask("PUT", "/api/v1/hil", isNamed, {});
  await asked;
  expect(sent).toHaveLength(2);
});

test("a file goes to the gateway byte for byte, not as JSON", async () => {
  const { rest, sent } = restThat(() => Response.json({ name: "x" }));
  const content = new Blob([new Uint8Array([0xff, 0xfe, 0x3c, 0x00])]);
  await rest.ask("POST", "/api/v1/missions/import?name=a.kml", isNamed, content);
  expect(sent[0]?.init.headers).toMatchObject({ "content-type": "application/octet-stream" });
  expect(sent[0]?.init.body).toBe(content);
});

test("a file comes from the gateway as it is, and a refusal as a problem", async () => {
  const { rest } = restThat(() => new Response("<kml/>"));
  const answer = await rest.file("/x", { waypoints: [] });
  expect(answer.ok && (await answer.value.text())).toBe("<kml/>");
  const refusing = restThat(() => Response.json({ code: "no", detail: "No." }, { status: 422 })).rest;
  expect(await refusing.file("/x", {})).toMatchObject({ ok: false, problem: { code: "no" } });
});
