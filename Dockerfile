# The images of EPF GCS. The last stage is the product: one virtual environment with the wheel inside, and nothing that
# built it. The stages named dev-... and journeys are those of docker-compose.yml.
#
#     docker build -t epf-gcs .        (or `podman build --format docker`: the OCI format has no health check)
#
# Built twice from the same sources and base images it holds the same files, byte for byte (`make image-digest`).

FROM docker.io/library/node:20-bookworm-slim AS page-packages
# The base's own user, by number: its sources belong to it, and Vite writes beside its packages.
RUN install -d -o 1000 -g 1000 /station /station/frontend
WORKDIR /station/frontend
ENV HOME=/tmp
USER 1000:1000
COPY --chown=1000:1000 frontend/package.json frontend/package-lock.json frontend/.npmrc ./
RUN npm ci --no-audit --no-fund
COPY --chown=1000:1000 frontend/ ./

FROM page-packages AS page
RUN npm run build

FROM docker.io/library/gcc:12-bookworm AS board
WORKDIR /station/firmware
COPY firmware/ ./
RUN make board-static

# Python with the one library of the system that the wheels expect and the slim image lacks: GDAL's reading of rasters.
FROM docker.io/library/python:3.11-slim-bookworm AS base
RUN apt-get update \
 && apt-get install -y --no-install-recommends libexpat1 \
 && rm -rf /var/lib/apt/lists/* /var/cache/apt/* /var/log/apt /var/log/*.log /var/cache/ldconfig/aux-cache \
      /var/lib/dpkg/*-old /var/cache/debconf/*-old

FROM base AS packages
# Where a package has no wheel for this processor (jsbsim on aarch64) it is built, and only the result goes on.
RUN if [ "$(uname -m)" != x86_64 ]; then \
      apt-get update && apt-get install -y --no-install-recommends g++ make && rm -rf /var/lib/apt/lists/*; fi
RUN python -m venv /opt/epf-gcs
COPY backend/requirements.lock /station/backend/
RUN /opt/epf-gcs/bin/pip install --no-cache-dir --no-compile --disable-pip-version-check --require-hashes \
      -r /station/backend/requirements.lock

FROM packages AS wheel
WORKDIR /station
COPY .ci/wheel.py .ci/
COPY LICENSE ./
COPY backend/pyproject.toml backend/README.md backend/
COPY backend/src backend/src
COPY firmware/third_party firmware/third_party
COPY --from=page /station/frontend/dist frontend/dist
COPY --from=board /station/firmware/build/static/epf-board firmware/build/static/epf-board
COPY packaging/container/slim.py packaging/container/
# Seconds since 1970 for all that stamps a time; the same ones give the same files.
ARG SOURCE_DATE_EPOCH=0
ENV SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH} PYTHONHASHSEED=0
RUN /opt/epf-gcs/bin/python .ci/wheel.py . /tmp/wheel \
 && /opt/epf-gcs/bin/pip install --no-cache-dir --no-compile --no-deps --disable-pip-version-check /tmp/wheel/*.whl \
 && python packaging/container/slim.py /opt/epf-gcs

# ---- development -------------------------------------------------------------------------------------

# The page from Vite, which takes each change of frontend/src into the open browser.
FROM page-packages AS dev-page
ENV NODE_ENV=development
EXPOSE 5173
CMD ["node", "node_modules/vite/bin/vite.js", "--host", "0.0.0.0", "--strictPort"]

# The gateway from backend/src, started again with each change.
FROM packages AS dev-gateway
COPY packaging/container/reload.lock /station/
RUN /opt/epf-gcs/bin/pip install --no-cache-dir --disable-pip-version-check --no-deps --require-hashes \
      -r /station/reload.lock
COPY packaging/container/health.py /usr/local/lib/epf-gcs/health.py
COPY backend/pyproject.toml backend/README.md /station/backend/
COPY backend/src /station/backend/src
RUN /opt/epf-gcs/bin/pip install --no-cache-dir --disable-pip-version-check --no-deps --no-build-isolation \
      -e /station/backend \
 && install -d -o 1000 -g 1000 /data
COPY --from=board /station/firmware/build/static/epf-board /station/firmware/build/posix/epf-board
ENV PATH=/opt/epf-gcs/bin:$PATH HOME=/tmp PYTHONDONTWRITEBYTECODE=1 PYTHONUNBUFFERED=1 GCS_HOST=0.0.0.0 GCS_DATA_DIR=/data
USER 1000:1000
VOLUME /data
EXPOSE 8000
CMD ["watchfiles", "--filter", "python", "--sigint-timeout", "15", "epf-gcs", "/station/backend/src"]

# The journeys in a real browser, against a station that runs elsewhere.
FROM docker.io/library/node:20-bookworm-slim AS journeys
RUN apt-get update && apt-get install -y --no-install-recommends chromium ca-certificates && rm -rf /var/lib/apt/lists/*
RUN install -d -o 1000 -g 1000 /station /station/e2e
WORKDIR /station/e2e
ENV HOME=/tmp PLAYWRIGHT_SKIP_BROWSER_DOWNLOAD=1
USER 1000:1000
COPY --chown=1000:1000 e2e/package.json e2e/package-lock.json ./
RUN npm ci --no-audit --no-fund
COPY --chown=1000:1000 e2e/ ./
CMD ["npx", "playwright", "test", "--grep", "@any-station"]

# ---- the product -------------------------------------------------------------------------------------

FROM base AS station
ARG SOURCE_DATE_EPOCH=0
# By number, so that it needs no name in the host's files; a serial port of the host belongs to dialout there and here.
RUN SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH} useradd --no-log-init --uid 1000 --home-dir /data --groups dialout pilot \
 && install -d -o 1000 -g 1000 -m 0700 /data \
 && rm -f /etc/passwd- /etc/group- /etc/shadow- /etc/gshadow- /etc/subuid- /etc/subgid- /var/log/lastlog /var/log/faillog
COPY LICENSE /usr/share/doc/epf-gcs/copyright
COPY packaging/container/health.py /usr/local/lib/epf-gcs/health.py
COPY --from=wheel /opt/epf-gcs /opt/epf-gcs
# It is used by other users than the one it is built for, and none of them has to write here.
ENV PATH=/opt/epf-gcs/bin:$PATH \
    HOME=/tmp \
    PYTHONDONTWRITEBYTECODE=1 \
    PYTHONUNBUFFERED=1 \
    GCS_HOST=0.0.0.0 \
    GCS_DATA_DIR=/data
USER 1000:1000
WORKDIR /data
VOLUME /data
EXPOSE 8000/tcp 49003/udp
STOPSIGNAL SIGTERM
# Whether both processes answer. A board whose cable was pulled is no reason to start the station again in flight.
HEALTHCHECK --interval=10s --timeout=5s --start-period=30s --retries=3 \
  CMD ["python", "-I", "/usr/local/lib/epf-gcs/health.py"]
ARG VERSION=unknown
ARG REVISION=unknown
LABEL org.opencontainers.image.title="EPF GCS" \
      org.opencontainers.image.description="Ground control station in the browser for a small fixed-wing autopilot board" \
      org.opencontainers.image.licenses="MIT" \
      org.opencontainers.image.version="${VERSION}" \
      org.opencontainers.image.revision="${REVISION}" \
      org.opencontainers.image.base.name="docker.io/library/python:3.11-slim-bookworm"
CMD ["epf-gcs"]
