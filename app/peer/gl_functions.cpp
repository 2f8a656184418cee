#include "gl_functions.hpp"

#include <dlfcn.h>

#include <cstdlib>
#include <type_traits>

namespace hs::peer {

namespace {

void* open_library() {
    // Both are read when the library creates its screen, once per process. A caller's own choice
    // stays.
    // NOLINTBEGIN(concurrency-mt-unsafe): documented, and once per process
    constexpr int keep_existing = 0;
    setenv("GALLIUM_DRIVER", "llvmpipe", keep_existing);
    setenv("LP_NUM_THREADS", "2", keep_existing);
    // NOLINTEND(concurrency-mt-unsafe)

    for (const char* name : {"libOSMesa.so.8", "libOSMesa.so"}) {
        // Local, so that its gl* symbols never replace those of a window's OpenGL.
        if (void* library = dlopen(name, RTLD_NOW | RTLD_LOCAL)) {
            return library;
        }
    }
    return nullptr;
}

OsMesa load() {
    OsMesa osmesa;
    void* const library = open_library();
    if (library == nullptr) {
        osmesa.why_not = "libOSMesa is not installed (Debian: apt install libosmesa6)";
        return osmesa;
    }

    const auto find = [&](auto& function, const char* name) {
        function =
            reinterpret_cast<std::remove_reference_t<decltype(function)>>(dlsym(library, name));
        if (function == nullptr) {
            osmesa.why_not = std::string("libOSMesa has no function ") + name;
        }
    };
    find(osmesa.create_context, "OSMesaCreateContextAttribs");
    find(osmesa.destroy_context, "OSMesaDestroyContext");
    find(osmesa.make_current, "OSMesaMakeCurrent");
    find(osmesa.current_context, "OSMesaGetCurrentContext");
    find(osmesa.get_proc_address, "OSMesaGetProcAddress");
    return osmesa;
}

} // namespace

const OsMesa& load_osmesa() {
    static const OsMesa osmesa = load();
    return osmesa;
}

Gl::Entry Gl::find(const char* name) {
    const Entry entry{get_proc_address_(name)};
    if (entry.procedure == nullptr) {
        missing_.emplace_back(name);
    }
    return entry;
}

} // namespace hs::peer
