# A container with Trilith: docker build -t trilith . && docker run --rm -v "$PWD:/work" trilith run model.lua
FROM debian:12-slim AS build
RUN apt-get update && apt-get install -y --no-install-recommends git ca-certificates
COPY . /source
WORKDIR /source
RUN ./dev package

FROM debian:12-slim
COPY --from=build /source/build/hardened/package/*.deb /tmp/
RUN apt-get update \
  && apt-get install -y --no-install-recommends /tmp/*.deb lua5.4 ffmpeg python3-h5py python3-pandas python3-matplotlib \
  && rm -rf /var/lib/apt/lists/* /tmp/*.deb \
  && trilith doctor
WORKDIR /work
ENTRYPOINT ["trilith"]
