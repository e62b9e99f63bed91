#!/usr/bin/env bash
# Run test programs and say in one line what passed.
#
#     run.sh RESULTS FLAVOUR PROGRAM...
#
# RESULTS: folder for one JUnit file a program (empty: none); FLAVOUR: how they were built, part of the files' names.
set -u
results=$1
flavour=$2
shift 2
failed=0
passed=0
log=$(mktemp)
trap 'rm -f "$log"' EXIT
if [ -n "$results" ]; then
  mkdir -p "$results"
  rm -f "$results/firmware-$flavour-"*.xml
fi
for program in "$@"; do
  name=$(basename "$program")
  if [ -n "$results" ]; then
    xml="$results/firmware-$flavour-$(basename "$(dirname "$program")")-$name.xml"
    CMOCKA_MESSAGE_OUTPUT=xml CMOCKA_XML_FILE="$xml" "$program" >"$log" 2>&1
  else
    xml=$log
    CMOCKA_MESSAGE_OUTPUT=subunit "$program" >"$log" 2>&1
  fi
  code=$?
  count=$(cat "$xml" 2>/dev/null | grep -c -e '<testcase ' -e '^success: ')
  passed=$((passed + count))
  if [ $code -ne 0 ] || [ "$count" -eq 0 ]; then
    failed=$((failed + 1))
    printf '%s (%s) failed:\n' "$program" "$flavour" >&2
    cat "$log" >&2
    [ "$xml" = "$log" ] || cat "$xml" >&2
  fi
done
if [ $failed -ne 0 ]; then
  printf 'firmware tests, %s: %d of %d programs failed\n' "$flavour" "$failed" $# >&2
  exit 1
fi
printf 'firmware tests, %s: %d tests in %d programs passed\n' "$flavour" "$passed" $#
