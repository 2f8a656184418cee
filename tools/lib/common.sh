# Shared by the scripts in tools/: where we are, what Debian must provide, how to build.
# shellcheck shell=bash disable=SC2034

top=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
cd "$top" || exit 2

# What the program needs to be built and to run.
packages_program=(
    g++ cmake ninja-build pkg-config ccache
    libglm-dev libfmt-dev libopenmesh-dev libopenimageio-dev libtomlplusplus-dev
    nlohmann-json3-dev libzip-dev liblua5.4-dev libmd4c-dev
    libglfw3-dev libgl-dev libgl1-mesa-dri libimgui-dev libcli11-dev
    libosmesa6 libosmesa6-dev
    fonts-inter fonts-jetbrains-mono fonts-dejavu-core
)

# What the tests need besides.
packages_tests=(catch2 libembree-dev xvfb xdotool python3-numpy openimageio-tools)

# What the second compiler and its tools need: digests, format, tidy, coverage, fuzzing.
packages_clang=(clang-14 clang-tidy-14 clang-format-14 llvm-14 libclang-rt-14-dev)

say() {
    printf '%s\n' "$*" >&2
}

die() {
    say "$@"
    exit 2
}

# need_packages <why> <package>...: installs what is missing, in one call of apt-get.
need_packages() {
    local why=$1 name status as_root=()
    shift
    if ! command -v dpkg-query >/dev/null; then
        say "This is not a Debian system, so libraries are not looked after; CMake names what is missing."
        return
    fi

    local -A installed=()
    while read -r name status; do
        if [[ $status == installed ]]; then
            installed[$name]=1
        fi
    done < <(dpkg-query -W -f='${Package} ${db:Status-Status}\n' "$@" 2>/dev/null || true)
    local missing=()
    for name in "$@"; do
        if [[ -z ${installed[$name]:-} ]]; then
            missing+=("$name")
        fi
    done
    if ((${#missing[@]} == 0)); then
        return
    fi

    if ((EUID != 0)); then
        command -v sudo >/dev/null || die "Packages are missing $why. As root, type: apt-get install ${missing[*]}"
        as_root=(sudo)
    fi
    say "Installing ${#missing[@]} Debian packages $why: ${missing[*]}"
    "${as_root[@]}" apt-get update -qq
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
        apt-get install -y -qq --no-install-recommends "${missing[@]}" </dev/null >/dev/null
}

# configure <preset> [cmake arguments...]: only when something asks for it; afterwards the build
# notices changed CMake files by itself.
configure() {
    local preset=$1
    shift
    if [[ $# -eq 0 && build/$preset/build.ninja -nt CMakePresets.json ]]; then
        return
    fi
    cmake --preset "$preset" "$@" >&2
}

# build <preset> [arguments of cmake --build...]
build() {
    local preset=$1
    shift
    cmake --build "build/$preset" "$@" >&2
}

# The C++ files of the repository, one per line.
source_files() {
    git ls-files -- '*.cpp' '*.hpp' | while read -r file; do
        if [[ -f $file ]]; then
            printf '%s\n' "$file"
        fi
    done
}
