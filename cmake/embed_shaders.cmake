# Embeds the texts of shading/ and shaders/ into a C++ source and has glslang check every stage.
#
# Included: defines burnish_embed_shaders(<generated source>) and burnish_check_shaders(<target>).
# Run with cmake -P: MODE=embed writes the source, MODE=check validates a folder of assembled stages.

if(NOT CMAKE_SCRIPT_MODE_FILE)
    set(BURNISH_EMBED_SCRIPT ${CMAKE_CURRENT_LIST_FILE})

    # Stages and what they include: a new file needs no list but its #include line.
    file(GLOB BURNISH_STAGES CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR}
         ${PROJECT_SOURCE_DIR}/shaders/*.vert ${PROJECT_SOURCE_DIR}/shaders/*.frag
         ${PROJECT_SOURCE_DIR}/shaders/lib/*.glsl)

    # Appends the texts of a list file in the order of its #include lines, those of lists that it
    # includes among them.
    function(burnish_append_texts texts list)
        set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${list})
        file(STRINGS ${PROJECT_SOURCE_DIR}/${list} lines REGEX "^#include \"")
        set(found ${${texts}})
        foreach(line IN LISTS lines)
            string(REGEX REPLACE "^#include \"([^\"]+)\".*" "\\1" name "${line}")
            if(name MATCHES "\\.hpp$")
                burnish_append_texts(found ${name})
            else()
                list(APPEND found ${name})
            endif()
        endforeach()
        set(${texts} ${found} PARENT_SCOPE)
    endfunction()
    set(BURNISH_TEXTS shading/prelude.glsl)
    burnish_append_texts(BURNISH_TEXTS shading/all.hpp)

    function(burnish_embed_shaders source)
        set(files ${BURNISH_TEXTS} ${BURNISH_STAGES})
        list(TRANSFORM files PREPEND ${PROJECT_SOURCE_DIR}/ OUTPUT_VARIABLE paths)
        string(REPLACE ";" "," texts "${BURNISH_TEXTS}")
        string(REPLACE ";" "," stages "${BURNISH_STAGES}")
        add_custom_command(OUTPUT ${source}
            COMMAND ${CMAKE_COMMAND} -DMODE=embed -DSOURCE_DIR=${PROJECT_SOURCE_DIR}
                -DOUTPUT=${source} -DTEXTS=${texts} -DSTAGES=${stages} -P ${BURNISH_EMBED_SCRIPT}
            DEPENDS ${paths} ${BURNISH_EMBED_SCRIPT}
            COMMENT "Embedding shaders" VERBATIM)
    endfunction()

    # Building everything then fails where glslang refuses a shader; `target` alone does not wait for
    # the check. The stages are assembled by the code that assembles them at run time.
    function(burnish_check_shaders target assembler)
        set(folder ${CMAKE_CURRENT_BINARY_DIR}/checked_shaders)
        add_custom_command(OUTPUT ${folder}.stamp
            COMMAND ${CMAKE_COMMAND} -DMODE=check -DASSEMBLER=$<TARGET_FILE:${assembler}>
                -DFOLDER=${folder} -DGLSLANG=${GLSLANG_VALIDATOR} -P ${BURNISH_EMBED_SCRIPT}
            COMMAND ${CMAKE_COMMAND} -E touch ${folder}.stamp
            DEPENDS ${assembler} ${BURNISH_EMBED_SCRIPT}
            COMMENT "Checking shaders with glslang" VERBATIM)
        add_custom_target(${target}_shaders_checked ALL DEPENDS ${folder}.stamp)
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
