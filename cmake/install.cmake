# cmake --install: the program, the library, its headers and the text of the maths, and what
# find_package(burnish) needs.
include(CMakePackageConfigHelpers)

set(BURNISH_INCLUDE ${CMAKE_INSTALL_INCLUDEDIR}/burnish-${PROJECT_VERSION})
set(BURNISH_PACKAGE ${CMAKE_INSTALL_LIBDIR}/cmake/burnish)

install(TARGETS burnish EXPORT burnish_targets
        LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
        INCLUDES DESTINATION ${BURNISH_INCLUDE})
if(TARGET burnish_codecs)  # fuzzers have the codecs in the program
    install(TARGETS burnish_codecs LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
endif()
if(TARGET burnish_view)
    install(TARGETS burnish_view RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
install(TARGETS burnish_cli RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/burnish DESTINATION ${BURNISH_INCLUDE})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/shading DESTINATION ${BURNISH_INCLUDE})
install(EXPORT burnish_targets NAMESPACE burnish:: DESTINATION ${BURNISH_PACKAGE})

configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/burnish-config.cmake.in
                              ${PROJECT_BINARY_DIR}/burnish-config.cmake
                              INSTALL_DESTINATION ${BURNISH_PACKAGE})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/burnish-config-version.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/burnish-config.cmake
              ${PROJECT_BINARY_DIR}/burnish-config-version.cmake
        DESTINATION ${BURNISH_PACKAGE})
