# SPDX-License-Identifier: GPL-3.0-or-later
# The command line as an image; the plugin is in its pvpython and pvserver as well.
#     docker build -t contour-reconstruct . && docker run --rm -v "$PWD:/data" contour-reconstruct rtss.dcm 'surfaces/{}.stl'
ARG SUITE=bookworm
FROM debian:${SUITE} AS build
COPY . /project
RUN apt-get update && /project/run package

FROM debian:${SUITE}
COPY --from=build /project/build/package/packages/*.deb /tmp/
RUN apt-get update && \
    DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends /tmp/*.deb && \
    rm -rf /tmp/*.deb /var/lib/apt/lists/*
WORKDIR /data
ENTRYPOINT ["contour-reconstruct"]
