# Warnings for our own targets only: link project_warnings PRIVATE. Whether they are errors is
# decided by the presets (CMAKE_COMPILE_WARNING_AS_ERROR), so nobody else's build breaks on them.
add_library(project_warnings INTERFACE)

target_compile_options(
    project_warnings
    INTERFACE
        -Wall
        -Wextra
        -Wpedantic
        -Wshadow
        -Wconversion
        -Wsign-conversion
        -Wdouble-promotion
        -Wcast-align
        -Wcast-qual
        -Wold-style-cast
        -Woverloaded-virtual
        -Wnon-virtual-dtor
        -Wformat=2
        -Wundef
        -Wredundant-decls
        -Wmissing-declarations
        -Wextra-semi
        -Wimplicit-fallthrough
        -Wswitch-enum
)

if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(
        project_warnings
        INTERFACE
            -Wduplicated-cond
            -Wduplicated-branches
            -Wlogical-op
            -Wsuggest-override
            -Wuseless-cast
            # GCC 12 warns inside std::string for "literal" + string (its bug 105651)
            -Wno-restrict
    )
elseif(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
    # GCC's -Wnull-dereference finds std::string null once its own headers are inlined.
    target_compile_options(
        project_warnings
        INTERFACE
            -Wnull-dereference
            -Wcomma
            -Wloop-analysis
            -Wunreachable-code-aggressive
            -Wextra-semi-stmt
            -Wheader-hygiene
            -Wimplicit-int-float-conversion
            -Wdocumentation
    )
endif()
