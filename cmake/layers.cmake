# Layers and tests as CMake targets.

# burnish_layer(<name> SOURCES ... [BELOW <layers>] [PACKAGES <targets>] [PRECOMPILE <headers>])
# adds the object library burnish_<name> of the folder src/<name>. BELOW names the layers that it may
# include; what they may include comes with them. tests/core/layers_test.cpp reads the same lists and
# scans the includes. PRECOMPILE names headers of packages that most sources of the layer include.
function(burnish_layer name)
    cmake_parse_arguments(ARG "" "" "SOURCES;BELOW;PACKAGES;PRECOMPILE" ${ARGN})
    add_library(burnish_${name} OBJECT ${ARG_SOURCES})
    list(TRANSFORM ARG_BELOW PREPEND burnish_ OUTPUT_VARIABLE below)
    target_link_libraries(burnish_${name} PUBLIC burnish_flags glm::glm ${below}
                          PRIVATE ${ARG_PACKAGES})
    if(ARG_PRECOMPILE)
        target_precompile_headers(burnish_${name} PRIVATE ${ARG_PRECOMPILE})
    endif()
    set_property(GLOBAL APPEND PROPERTY BURNISH_LAYERS ${name})
    string(REPLACE ";" " " below_names "${ARG_BELOW}")
    set_property(GLOBAL APPEND PROPERTY BURNISH_LAYER_LINES "${name}: ${below_names}")
endfunction()

# Sources whose parts of Eigen under other licences than the MPL do not compile.
function(burnish_mpl_eigen)
    set_source_files_properties(${ARGN} PROPERTIES COMPILE_DEFINITIONS EIGEN_MPL2_ONLY)
endfunction()

# Sources of inner loops over several values at a time: no value depends on errno or traps.
function(burnish_vector_loops)
    set_source_files_properties(${ARGN} PROPERTIES
                                COMPILE_OPTIONS "-fno-math-errno;-fno-trapping-math")
endfunction()
