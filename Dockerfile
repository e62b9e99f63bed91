# The images of EPF GCS. The last stage is the product: one virtual environment with the wheel inside, and nothing that
# built it. The stages named dev-... and journeys are those of docker-compose.yml.
#
#     docker build -t epf-gcs .        (or `podman build --format docker`: the OCI format has no health check)
#
# Built twice from the same sources and base images it holds the same files, byte for byte.

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
RUN make board-static laws

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
RUN /opt/epf-gcs/bin/pip install --no-cache-dir --no-compile --disable-pip-version-check --no-deps --require-hashes \
      -r /station/backend/requirements.lock

FROM packages AS wheel
WORKDIR /station
COPY .ci/wheel.py .ci/sbom.py .ci/shipped.py .ci/
COPY LICENSE ./
COPY backend/pyproject.toml backend/README.md backend/
COPY backend/src backend/src
COPY firmware/third_party firmware/third_party
# What the bill of materials and the licences are made from, beside what is installed.
COPY frontend/package-lock.json frontend/
COPY frontend/scripts/mapData.json frontend/scripts/
COPY --from=page /station/frontend/dist frontend/dist
COPY --from=board /station/firmware/build/static/epf-board firmware/build/static/epf-board
COPY --from=board /station/firmware/build/posix/libepf-flight.so firmware/build/posix/libepf-flight.so
COPY packaging/container/slim.py packaging/container/
RUN apt-get update && apt-get install -y --no-install-recommends binutils && rm -rf /var/lib/apt/lists/*
# Seconds since 1970 for all that stamps a time; the same ones give the same files.
ARG SOURCE_DATE_EPOCH=0
ENV SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH} PYTHONHASHSEED=0
RUN /opt/epf-gcs/bin/python .ci/wheel.py . /tmp/wheel \
 && /opt/epf-gcs/bin/pip install --no-cache-dir --no-compile --no-deps --disable-pip-version-check /tmp/wheel/*.whl \
 && ln -s ../lib/python3.11/site-packages/epf_gcs/_product/board/posix/epf-board /opt/epf-gcs/bin/epf-board \
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
COPY packaging/container/health.py packaging/container/connect.py /usr/local/lib/epf-gcs/
COPY backend/pyproject.toml backend/README.md /station/backend/
COPY backend/src /station/backend/src
RUN /opt/epf-gcs/bin/pip install --no-cache-dir --disable-pip-version-check --no-deps --no-build-isolation \
      -e /station/backend \
 && install -d -o 1000 -g 1000 -m 0700 /data /card /keys \
 && ln -s /station/firmware/build/posix/epf-board /opt/epf-gcs/bin/epf-board
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
CMD ["npx", "playwright", "test"]

# ---- the product -------------------------------------------------------------------------------------

FROM base AS assembled
ARG SOURCE_DATE_EPOCH=0
ENV PYTHONHASHSEED=0
# By number, so that it needs no name in the host's files; a serial port of the host belongs to dialout there and here.
RUN SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH} useradd --no-log-init --uid 1000 --home-dir /data --groups dialout pilot \
 && install -d -o 1000 -g 1000 -m 0700 /data /card /keys \
 && rm -f /etc/passwd- /etc/group- /etc/shadow- /etc/gshadow- /etc/subuid- /etc/subgid- /var/log/lastlog /var/log/faillog
# Nothing is installed into it later: what could goes too, and what only boots or administers a computer, and C's tables of
# letters (Python has its own).
RUN rm -rf /usr/local/lib/python3.11 /usr/local/bin/pip* /usr/local/bin/idle* /usr/local/bin/2to3* /usr/local/bin/pydoc* \
 && for name in apt libapt-pkg6.0 gpgv debian-archive-keyring adduser debconf e2fsprogs logsave libext2fs2 libss2 \
      libcom-err2 login passwd mount util-linux util-linux-extra bsdutils sysvinit-utils init-system-helpers openssl \
      libpam-modules libpam-modules-bin libpam-runtime libpam0g libaudit1 libaudit-common libcap-ng0 libsemanage2 \
      libsemanage-common libsepol2 libdb5.3 libgnutls30 libgcrypt20 libgpg-error0 libp11-kit0 libhogweed6 libnettle8 \
      libidn2-0 libunistring2 libtasn1-6 libgmp10 libsystemd0 libudev1 libmount1 libblkid1 libsmartcols1 libdebconfclient0 \
      libxxhash0 usr-is-merged perl-base; do \
      if dpkg-query -W "$name" >/dev/null 2>&1; then \
        rm -f /var/lib/dpkg/info/$name.prerm /var/lib/dpkg/info/$name.postrm /var/lib/dpkg/info/$name:*.prerm /var/lib/dpkg/info/$name:*.postrm; \
        dpkg --purge --force-depends --force-remove-essential --force-remove-protected "$name" >/dev/null 2>&1; fi; done \
 && rm -rf /var/lib/dpkg/*-old /var/log/*.log /var/cache/ldconfig /var/cache/debconf /etc/apt /var/lib/apt \
      /usr/lib/*-linux-gnu/gconv
COPY --from=wheel /usr/local/lib/python3.11 /usr/local/lib/python3.11
COPY LICENSE /usr/share/doc/epf-gcs/copyright
COPY packaging/container/health.py packaging/container/connect.py /usr/local/lib/epf-gcs/
COPY --from=wheel /opt/epf-gcs /opt/epf-gcs

# In one layer, for a layer keeps what a later one deletes.
FROM scratch AS station
COPY --from=assembled / /
# It is used by other users than the one it is built for, and none of them has to write here.
ENV PATH=/opt/epf-gcs/bin:/usr/local/bin:/usr/local/sbin:/usr/bin:/usr/sbin:/bin:/sbin \
    LANG=C.UTF-8 \
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
