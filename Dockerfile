# fascia on a bare Debian 12, with the packages of scripts/packages.sh: pictures, videos and checks without display and GPU.
#
#   docker build -t fascia .
#   docker run --rm fascia                                                   checks the shipped scenes
#   docker run --rm -v "$PWD:/work" --user "$(id -u):$(id -g)" fascia check scenes --context osmesa --junit report.xml --out failures
FROM debian:12
WORKDIR /usr/local/src/fascia
COPY scripts/packages.sh scripts/
RUN bash -c 'source scripts/packages.sh && install_missing "${build_packages[@]}" "${run_packages[@]}"' && rm -rf /var/lib/apt/lists/*
COPY . .
RUN bash -c 'source scripts/packages.sh && build_preset release' && cmake --install build/release --prefix /usr/local && rm -rf build
WORKDIR /work
ENTRYPOINT ["fascia"]
CMD ["check", "/usr/local/share/fascia/assets/check", "--context", "osmesa"]
