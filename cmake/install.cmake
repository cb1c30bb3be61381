# cmake --install: headers, static library, CMake package, pkg-config file, and the command line
# where it was built.
include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/roomseg)

install(TARGETS roomseg EXPORT roomseg-targets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY include/roomseg DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
        FILES_MATCHING PATTERN "*.h")
install(EXPORT roomseg-targets NAMESPACE roomseg:: DESTINATION ${package_dir})

configure_package_config_file(cmake/roomseg-config.cmake.in
    ${PROJECT_BINARY_DIR}/roomseg-config.cmake INSTALL_DESTINATION ${package_dir})
# Before 1.0 a minor version may change the interface.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/roomseg-config-version.cmake
    COMPATIBILITY SameMinorVersion)
install(FILES
    ${PROJECT_BINARY_DIR}/roomseg-config.cmake
    ${PROJECT_BINARY_DIR}/roomseg-config-version.cmake
    DESTINATION ${package_dir})

# The .pc file finds the prefix from where it lies, so an installed tree can be moved.
set(pc_dir ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
if(IS_ABSOLUTE "${CMAKE_INSTALL_LIBDIR}")
    set(pc_prefix ${CMAKE_INSTALL_PREFIX})
    set(pc_libdir ${CMAKE_INSTALL_LIBDIR})
else()
    file(RELATIVE_PATH up "/${pc_dir}" "/")
    string(REGEX REPLACE "/$" "" up "${up}")
    set(pc_prefix "\${pcfiledir}/${up}")
    set(pc_libdir "\${prefix}/${CMAKE_INSTALL_LIBDIR}")
endif()
if(IS_ABSOLUTE "${CMAKE_INSTALL_INCLUDEDIR}")
    set(pc_includedir ${CMAKE_INSTALL_INCLUDEDIR})
else()
    set(pc_includedir "\${prefix}/${CMAKE_INSTALL_INCLUDEDIR}")
endif()
configure_file(cmake/roomseg.pc.in ${PROJECT_BINARY_DIR}/roomseg.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/roomseg.pc DESTINATION ${pc_dir})

if(TARGET roomseg_cli)
    install(TARGETS roomseg_cli RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
