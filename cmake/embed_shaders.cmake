# Embeds the texts of shading/ and shaders/ into a C++ source and has glslang check every stage.
#
# Included: defines burnish_embed_shaders(<generated source>) and burnish_check_shaders(<target>).
# Run with cmake -P: MODE=embed writes the source, MODE=check validates a folder of assembled stages.

if(NOT CMAKE_SCRIPT_MODE_FILE)
    set(BURNISH_STAGES
        accumulate.frag background.frag fullscreen.vert gbuffer.frag gouraud.frag gouraud.vert
        ground.frag ground.vert ground_add.frag
        prefilter.frag resolve.frag shadow.frag surface.frag surface.vert
        lib/cloth.glsl lib/cloth_mean.glsl lib/environment.glsl lib/ground.glsl lib/image_light.glsl lib/lights.glsl
        lib/material.glsl
        lib/output.glsl lib/pack.glsl lib/prefiltered_light.glsl lib/random.glsl lib/shade.glsl lib/specular.glsl lib/surface.glsl
        lib/tabulated.glsl lib/tabulated_texels.glsl)
    set(BURNISH_EMBED_SCRIPT ${CMAKE_CURRENT_LIST_FILE})

    # The order of the texts of shading/ is that of the #include lines of all.hpp.
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS
                 ${PROJECT_SOURCE_DIR}/shading/all.hpp)
    file(STRINGS ${PROJECT_SOURCE_DIR}/shading/all.hpp lines REGEX "^#include \"")
    set(BURNISH_TEXTS shading/prelude.glsl)
    foreach(line IN LISTS lines)
        string(REGEX REPLACE "^#include \"([^\"]+)\".*" "\\1" name "${line}")
        list(APPEND BURNISH_TEXTS ${name})
    endforeach()

    function(burnish_embed_shaders source)
        list(TRANSFORM BURNISH_STAGES PREPEND shaders/ OUTPUT_VARIABLE stages)
        set(files ${BURNISH_TEXTS} ${stages})
        list(TRANSFORM files PREPEND ${PROJECT_SOURCE_DIR}/ OUTPUT_VARIABLE paths)
        string(REPLACE ";" "," texts "${BURNISH_TEXTS}")
        string(REPLACE ";" "," stages "${stages}")
        add_custom_command(OUTPUT ${source}
            COMMAND ${CMAKE_COMMAND} -DMODE=embed -DSOURCE_DIR=${PROJECT_SOURCE_DIR}
                -DOUTPUT=${source} -DTEXTS=${texts} -DSTAGES=${stages} -P ${BURNISH_EMBED_SCRIPT}
            DEPENDS ${paths} ${BURNISH_EMBED_SCRIPT}
            COMMENT "Embedding shaders" VERBATIM)
    endfunction()

    # `target` is then built only from shaders that glslang accepts. The stages are assembled by the
    # code that assembles them at run time.
    function(burnish_check_shaders target assembler)
        set(folder ${CMAKE_CURRENT_BINARY_DIR}/checked_shaders)
        add_custom_command(OUTPUT ${folder}.stamp
            COMMAND ${CMAKE_COMMAND} -DMODE=check -DASSEMBLER=$<TARGET_FILE:${assembler}>
                -DFOLDER=${folder} -DGLSLANG=${GLSLANG_VALIDATOR} -P ${BURNISH_EMBED_SCRIPT}
            COMMAND ${CMAKE_COMMAND} -E touch ${folder}.stamp
            DEPENDS ${assembler} ${BURNISH_EMBED_SCRIPT}
            COMMENT "Checking shaders with glslang" VERBATIM)
        add_custom_target(${target}_shaders_checked DEPENDS ${folder}.stamp)
        add_dependencies(${target} ${target}_shaders_checked)
    endfunction()
    return()
endif()

if(MODE STREQUAL embed)
    string(REPLACE "," ";" TEXTS "${TEXTS}")
    string(REPLACE "," ";" STAGES "${STAGES}")
    list(LENGTH TEXTS text_count)
    set(out "// Generated from shading/ and shaders/ by cmake/embed_shaders.cmake.\n")
    string(APPEND out "#include \"gpu/device/shader_source.hpp\"\n\nnamespace burnish::gpu {\nnamespace {\n")
    string(APPEND out "constexpr ShaderText kTexts[] = {\n")
    foreach(name IN LISTS TEXTS STAGES)
        file(READ ${SOURCE_DIR}/${name} text)
        string(APPEND out "    {\"${name}\", R\"GLSL(${text})GLSL\"},\n")
    endforeach()
    string(APPEND out "};\n}  // namespace\n\n")
    string(APPEND out "std::span<const ShaderText> shader_texts() { return kTexts; }\n\n")
    string(APPEND out "std::span<const ShaderText> shading_texts() {\n")
    string(APPEND out "    return std::span<const ShaderText>(kTexts).first(${text_count});\n}\n\n")
    string(APPEND out "}  // namespace burnish::gpu\n")
    file(WRITE ${OUTPUT} "${out}")
elseif(MODE STREQUAL check)
    file(REMOVE_RECURSE ${FOLDER})
    file(MAKE_DIRECTORY ${FOLDER})
    execute_process(COMMAND ${ASSEMBLER} ${FOLDER} RESULT_VARIABLE failed)
    if(failed)
        message(FATAL_ERROR "the shaders could not be assembled")
    endif()
    file(GLOB stages ${FOLDER}/*.vert ${FOLDER}/*.frag)
    execute_process(COMMAND ${GLSLANG} ${stages} RESULT_VARIABLE failed OUTPUT_VARIABLE out)
    if(failed)
        string(REGEX MATCHALL "[^\n]*ERROR[^\n]*" errors "${out}")
        string(REPLACE ";" "\n" errors "${errors}")
        message(FATAL_ERROR "glslang refuses shaders assembled in ${FOLDER}:\n${errors}")
    endif()
endif()
