import { type Checked, isNumber, isObject, isText, list, nullable, oneOf, shape } from "../../lib/check";

const isCertificate = shape({
  kind: oneOf("made", "brought"),
  names: list(isText),
  addresses: list(isText),
  fingerprint: isText,
  since_s: isNumber,
  until_s: isNumber,
});
const isAuthority = shape({ name: isText, fingerprint: isText, until_s: isNumber });
export const isCertificates = shape({
  certificate: nullable(isCertificate),
  authority: nullable(isAuthority),
  fault: nullable(shape({ code: isText, detail: isText, params: isObject })),
});
export type Certificates = Checked<typeof isCertificates>;
