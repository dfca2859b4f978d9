# Layers as CMake targets.

# Two precompiled headers serve the library: the headers of packages that most sources include. One
# is compiled as the layers of inner loops are, the other as the light layers below.
set(BURNISH_COMMON_HEADERS <algorithm> <array> <cmath> <filesystem> <fmt/format.h> <fstream>
    <functional> <glm/glm.hpp> <map> <memory> <numbers> <optional> <span> <string> <string_view>
    <vector>)

# Layers without inner loops of their own: a Release compiles them for a short build.
set(BURNISH_LIGHT_LAYERS formats stage plot export jobs viewer)
set(BURNISH_LIGHT_OPTIONS $<$<CONFIG:Release>:-O1>)

# burnish_headers(<target> [<headers>]) adds the target that compiles BURNISH_COMMON_HEADERS and
# <headers>.
function(burnish_headers target)
    set(source ${CMAKE_CURRENT_BINARY_DIR}/${target}.cpp)
    file(CONFIGURE OUTPUT ${source} CONTENT "")
    add_library(${target} OBJECT ${source})
    target_link_libraries(${target} PRIVATE burnish_flags glm::glm fmt::fmt)
    target_precompile_headers(${target} PRIVATE ${BURNISH_COMMON_HEADERS} ${ARGN})
endfunction()

# burnish_unity(<target>): several sources are compiled at a time, as most of the time that a source
# takes goes into headers. So their names in anonymous namespaces differ. Sources with options of
# their own are compiled alone.
function(burnish_unity target)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ${BURNISH_UNITY}
                          UNITY_BUILD_BATCH_SIZE 12)
endfunction()

# burnish_light(<target>): the target is compiled as the light layers are.
function(burnish_light target)
    target_compile_options(${target} PRIVATE ${BURNISH_LIGHT_OPTIONS})
    target_precompile_headers(${target} REUSE_FROM burnish_light_headers)
    burnish_unity(${target})
endfunction()

burnish_headers(burnish_loop_headers)
burnish_headers(burnish_light_headers <nlohmann/json.hpp>)
target_compile_options(burnish_light_headers PRIVATE ${BURNISH_LIGHT_OPTIONS})

# burnish_layer(<name> SOURCES ... [BELOW <layers>] [PACKAGES <targets>])
# adds the object library burnish_<name> of the folder src/<name>. BELOW names the layers that it may
# include; what they may include comes with them. build/<preset>/layers.txt receives these names, and
# tests/core/layers_test.cpp holds the includes against it.
function(burnish_layer name)
    cmake_parse_arguments(ARG "" "" "SOURCES;BELOW;PACKAGES" ${ARGN})
    add_library(burnish_${name} OBJECT ${ARG_SOURCES})
    list(TRANSFORM ARG_BELOW PREPEND burnish_ OUTPUT_VARIABLE below)
    target_link_libraries(burnish_${name} PUBLIC burnish_flags glm::glm ${below}
                          PRIVATE ${ARG_PACKAGES})
    if(name IN_LIST BURNISH_LIGHT_LAYERS)
        burnish_light(burnish_${name})
    else()
        target_precompile_headers(burnish_${name} REUSE_FROM burnish_loop_headers)
        burnish_unity(burnish_${name})
    endif()
    set_property(GLOBAL APPEND PROPERTY BURNISH_LAYERS ${name})
    string(REPLACE ";" " " below_names "${ARG_BELOW}")
    set_property(GLOBAL APPEND PROPERTY BURNISH_LAYER_LINES "${name}: ${below_names}")
endfunction()

# Sources whose parts of Eigen under other licences than the MPL do not compile.
function(burnish_mpl_eigen)
    set_source_files_properties(${ARGN} PROPERTIES COMPILE_DEFINITIONS EIGEN_MPL2_ONLY)
endfunction()

# Sources of light layers that loop over pixels or texels: compiled as the layers of inner loops are.
# GCC does not take a header that was precompiled without these options.
function(burnish_pixel_loops)
    set_source_files_properties(${ARGN} PROPERTIES COMPILE_OPTIONS "$<$<CONFIG:Release>:-O3>"
                                SKIP_PRECOMPILE_HEADERS ON)
endfunction()

# Sources of inner loops over several values at a time: no value depends on errno or traps. GCC does
# not take a header that was precompiled without these options.
function(burnish_vector_loops)
    set_source_files_properties(${ARGN} PROPERTIES
                                COMPILE_OPTIONS "-fno-math-errno;-fno-trapping-math"
                                SKIP_PRECOMPILE_HEADERS ON)
endfunction()
