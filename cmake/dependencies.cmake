# Debian 12 packages; docs/develop/architecture.md says what each is for.
find_package(PkgConfig REQUIRED)
find_package(glm REQUIRED)
find_package(fmt REQUIRED)
find_package(TBB REQUIRED)
find_package(embree 3 REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(CLI11 REQUIRED)
find_package(TinyGLTF REQUIRED)
find_package(tinyobjloader REQUIRED)
find_package(meshoptimizer REQUIRED)
find_package(Eigen3 REQUIRED NO_MODULE)
# Debian's draco holds a tinygltf and an stb of its own, of other versions than libtinygltf's, and
# libdraco.so exports them: which of the two a program calls then depends on the link line. So its
# archive is linked, without the member that holds them, and its symbols stay inside.
find_path(DRACO_INCLUDE_DIR draco/compression/decode.h REQUIRED)
find_library(DRACO_ARCHIVE libdraco.a REQUIRED)
set(draco_decoder ${PROJECT_BINARY_DIR}/libdraco_decoder.a)
file(COPY_FILE ${DRACO_ARCHIVE} ${draco_decoder})
execute_process(COMMAND ${CMAKE_AR} d ${draco_decoder} tiny_gltf_utils.cc.o COMMAND_ERROR_IS_FATAL ANY)
add_library(draco_archive STATIC IMPORTED)
set_target_properties(draco_archive PROPERTIES IMPORTED_LOCATION ${draco_decoder}
    INTERFACE_INCLUDE_DIRECTORIES ${DRACO_INCLUDE_DIR}
    INTERFACE_LINK_OPTIONS LINKER:--exclude-libs,libdraco_decoder.a)
# Headers only; its CMake target would link xtl, which Debian does not have as a library.
find_path(XSIMD_INCLUDE_DIR xsimd/xsimd.hpp REQUIRED)
find_package(ZLIB REQUIRED)
find_package(OpenEXR REQUIRED)
pkg_check_modules(oiio REQUIRED IMPORTED_TARGET OpenImageIO)
pkg_check_modules(heif REQUIRED IMPORTED_TARGET libheif)
pkg_check_modules(cairo REQUIRED IMPORTED_TARGET cairo cairo-svg)
pkg_check_modules(epoxy REQUIRED IMPORTED_TARGET epoxy)
pkg_check_modules(egl REQUIRED IMPORTED_TARGET egl)
find_program(GLSLANG_VALIDATOR glslangValidator REQUIRED)
