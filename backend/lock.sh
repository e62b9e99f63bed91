#!/usr/bin/env bash
# Write the lock files again from pyproject.toml; the hashes pin the files, and no registry is named.
set -eu
cd "$(dirname "$0")"
compile() { # compile OUTPUT EXTRA...
  output=$1
  shift
  uv pip compile --quiet --universal --python-version 3.11 --generate-hashes --no-emit-index-url \
    --custom-compile-command "backend/lock.sh" "$@" --output-file "$output" pyproject.toml
}
compile requirements.lock --extra build --extra all
compile requirements-dev.lock --extra build --extra all --extra lab --extra dev
compile requirements-mutate.lock --extra build --extra all --extra lab --extra dev --extra mutate
compile requirements-publish.lock --extra build --extra all --extra lab --extra dev --extra publish
