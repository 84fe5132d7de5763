# docker build -t layoutbox . && docker run --rm -v "$PWD/rooms:/rooms" layoutbox generate "A bedroom with a bed and a desk" -o /rooms/first
# The build takes some five minutes; the image holds the program, its solver library and Blender, and nothing of the compiler.
FROM debian:12-slim AS build
COPY . /source
RUN /source/scripts/build.sh layoutbox layoutbox_library && { /source/scripts/page.sh || true; } && cmake --install /source/build/release --prefix /opt/layoutbox && \
    cp -r /source/build/deps/bpy /opt/bpy && cp /source/scripts/packages.txt /opt/layoutbox/packages.txt

FROM debian:12-slim
COPY --from=build /opt /opt
RUN apt-get update && apt-get install -y --no-install-recommends libfmt9 libcpp-httplib0.11 libsqlite3-0 libmeshoptimizer2d libcurl4 zlib1g python3 ca-certificates \
      $(awk '$1 == "picture" || $1 == "bpy" || $1 == "sandbox" {print $3}' /opt/layoutbox/packages.txt) && rm -rf /var/lib/apt/lists/* && \
    ln -s /opt/layoutbox/bin/layoutbox /usr/local/bin/layoutbox && useradd --create-home --uid 1000 layoutbox && \
    mkdir /rooms && chown layoutbox /rooms
ENV LAYOUTBOX_BLENDER=/opt/bpy/bin/python
USER layoutbox
WORKDIR /rooms
ENTRYPOINT ["layoutbox"]
