# Every library the project uses, found once. What is missing is collected and named together,
# with the one apt line that brings it.
find_package(PkgConfig QUIET)
set(missing_packages "")

# need_package(<CMake package> <Debian package> [find_package arguments…])
macro(need_package name debian_package)
    find_package(${name} ${ARGN} QUIET)
    if(NOT ${name}_FOUND)
        list(APPEND missing_packages ${debian_package})
    endif()
endmacro()

# need_module(<name> <pkg-config module> <Debian package>) defines the target PkgConfig::<name>.
macro(need_module name module debian_package)
    if(PkgConfig_FOUND)
        pkg_check_modules(${name} QUIET IMPORTED_TARGET ${module})
    endif()
    if(NOT ${name}_FOUND)
        list(APPEND missing_packages ${debian_package})
    endif()
endmacro()

if(NOT PkgConfig_FOUND)
    list(APPEND missing_packages pkg-config)
endif()

# core and the lessons' loader
need_package(Threads libc6-dev)
need_package(glm libglm-dev)
need_package(fmt libfmt-dev)
need_package(OpenMesh libopenmesh-dev)
need_package(tomlplusplus libtomlplusplus-dev)
need_package(nlohmann_json nlohmann-json3-dev)
need_module(OpenImageIO OpenImageIO libopenimageio-dev) # its CMake package names a missing folder
need_module(libzip libzip libzip-dev)
need_module(lua lua5.4 liblua5.4-dev)
need_module(md4c md4c libmd4c-dev) # its CMake package is a fatal error

if(BUILD_APP)
    set(OpenGL_GL_PREFERENCE GLVND)
    need_package(OpenGL libgl-dev COMPONENTS OpenGL)
    need_package(glfw3 libglfw3-dev)
    need_package(CLI11 libcli11-dev)
    need_module(imgui imgui libimgui-dev)
    need_module(osmesa osmesa libosmesa6-dev) # for its header: the library is loaded at run time
endif()

if(BUILD_TESTS)
    need_package(Catch2 catch2)
    find_package(embree 3 QUIET) # an oracle of the tests, which do without it when absent
endif()

if(missing_packages)
    list(REMOVE_DUPLICATES missing_packages)
    list(JOIN missing_packages " " missing_packages)
    message(
        FATAL_ERROR
        "Halfspace needs libraries that were not found. To install them, type\n"
        "    sudo apt install ${missing_packages}\n"
        "and configure again. (tools/run and tools/test do this by themselves. "
        "-DBUILD_APP=OFF does without GLFW, ImGui and OpenGL.)"
    )
endif()
