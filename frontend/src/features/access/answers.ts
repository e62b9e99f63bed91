import { type Checked, isFlag, isText, nullable, oneOf, shape } from "../../lib/check";

export const isMe = shape({
  state: oneOf("stranger", "waiting", "in"),
  kind: nullable(oneOf("local", "person", "program", "anyone")),
  role: nullable(oneOf("viewer", "operator", "owner")),
  name: nullable(isText),
  anyone_may_fly: isFlag,
});
export type Me = Checked<typeof isMe>;
