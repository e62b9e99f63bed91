/** Names and values of slow facts, in two columns. */
export function Facts({ facts }: { facts: ReadonlyArray<readonly [name: string, value: string]> }) {
  return (
    <dl className="setup-facts">
      {facts.map(([name, value]) => (
        <div key={name} className="setup-fact">
          <dt>{name}</dt>
          <dd>{value}</dd>
        </div>
      ))}
    </dl>
  );
}
