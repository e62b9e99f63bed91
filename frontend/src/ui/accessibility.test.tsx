import axe from "axe-core";
import type { ComponentProps } from "react";
import { expect, test } from "vitest";
import { AlarmStrip } from "./AlarmStrip";
import { Button } from "./Button";
import { MessageLine } from "./MessageLine";
import { Meter } from "./Meter";
import { Notice } from "./Notice";
import { NumberField } from "./NumberField";
import { Panel } from "./Panel";
import { Readout, ReadoutGrid } from "./Readout";
import { SegmentedSwitch } from "./SegmentedSwitch";
import { Select } from "./Select";
import { StaleCross } from "./StaleCross";
import { StatusFlag } from "./StatusFlag";
import { StreamBadge } from "./StreamBadge";
import { Tabs } from "./Tabs";
import { TextField } from "./TextField";
import { Toolbar } from "./Toolbar";
import { renderWithWords } from "./test/testWords";

const nothing = () => undefined;
const PATHS = [
  { value: "manual", label: "Manual" },
  { value: "assisted", label: "Assisted" },
] as const;

const ENDED: ComponentProps<typeof AlarmStrip>["ended"] = {
  label: "ended",
  items: [{ id: "c", level: "warning", text: "open", detail: "12:03:04" }],
  acknowledge: { label: (text) => `seen ${text}`, onPress: nothing },
};

/** Every control in every state that changes its roles or attributes. */
function Everything() {
  return (
    <main>
      <h1>Controls</h1>
      <AlarmStrip
        label="Alarms"
        quiet="none"
        alarms={[
          { id: "a", level: "critical", text: "lost", detail: "4 s", acknowledged: false },
          { id: "b", level: "warning", text: "low", acknowledged: true },
        ]}
        ended={ENDED}
        acknowledge={{ label: (text) => `know ${text}`, text: "know", onPress: nothing }}
      />
      <AlarmStrip
        label="Ended"
        quiet="none"
        alarms={[]}
        ended={ENDED}
        acknowledge={{ label: (text) => `know ${text}`, text: "know", onPress: nothing }}
      />
      <Toolbar label="Bar">
        <Button onPress={nothing} pressed state="pending">
          On
        </Button>
        <Button onPress={nothing} disabledReason="no link">
          Off
        </Button>
        <Button onPress={nothing} icon={<svg aria-hidden="true" />} label="Refresh" state="rejected">
          {null}
        </Button>
        <SegmentedSwitch
          label="Path"
          options={PATHS}
          value="manual"
          wanted="assisted"
          state="pending"
          onChange={nothing}
        />
        <SegmentedSwitch
          label="Other"
          options={PATHS}
          value={null}
          disabledReason="no link"
          onChange={nothing}
        />
      </Toolbar>
      <Panel title="Gyros" badge={<StreamBadge label="Gyros" />}>
        <ReadoutGrid columns={2}>
          <Readout label="P" unit="deg/s" />
        </ReadoutGrid>
        <StatusFlag label="GPS" value={null} />
        <NumberField label="k" value={1} minimum={0} maximum={2} step={1} onCommit={nothing} />
        <NumberField
          label="off"
          value={1}
          minimum={0}
          maximum={2}
          step={1}
          onCommit={nothing}
          disabledReason="no link"
        />
        <TextField label="Host" value="x" onCommit={nothing} error="no such host" />
        <TextField label="Line" hideLabel value="x" onCommit={nothing} disabledReason="no link" />
        <Select label="Port" options={PATHS} value={null} placeholder="choose" onChange={nothing} />
        <Select
          label="Baud"
          options={PATHS}
          value="manual"
          placeholder="choose"
          onChange={nothing}
          disabledReason="open"
        />
        <Notice level="error" onDismiss={nothing}>
          text
        </Notice>
        <StaleCross text="NO DATA" />
      </Panel>
      <Tabs label="Main" tabs={PATHS.map(({ value, label }) => ({ value, label, content: label }))} />
      <MessageLine label="Message" text="opened" />
      <Meter label="RX" />
    </main>
  );
}

test("no control breaks a rule of accessibility", async () => {
  const { container } = renderWithWords(<Everything />);
  const { violations, passes } = await axe.run(container, {
    // Colours have their own test: jsdom has no layout.
    rules: { "color-contrast": { enabled: false } },
  });
  expect(violations.map(({ id, nodes }) => [id, nodes.map(({ html }) => html)])).toEqual([]);
  expect(passes.map(({ id }) => id)).toEqual(
    expect.arrayContaining(["button-name", "label", "select-name", "definition-list"]),
  );
});
