# Uses roomseg as another project would, and runs examples/firmware.c with it.
#
#   cmake -DWAY=find_package|pkg_config|subproject -DSOURCE=DIR -DBUILD=DIR -DWORK=DIR -DCC=FILE
#         -DFLAGS=TEXT -DLIBDIR=DIR -DCONFIG=TYPE -P check.cmake
#
# The installed tree is moved before it is used: nothing in it may name the place it was made in.
cmake_minimum_required(VERSION 3.16)
set(EXAMPLE ${SOURCE}/examples/firmware.c)
set(prefix ${WORK}/moved)

function(must)
    execute_process(COMMAND ${ARGN} RESULT_VARIABLE code OUTPUT_VARIABLE text ERROR_VARIABLE text)
    if(NOT code EQUAL 0)
        string(REPLACE ";" " " command "${ARGN}")
        message(FATAL_ERROR "${command}\n${text}")
    endif()
    set(output "${text}" PARENT_SCOPE)
endfunction()

function(install_and_move)
    must(${CMAKE_COMMAND} --install ${BUILD} --config "${CONFIG}" --prefix ${WORK}/installed)
    file(RENAME ${WORK}/installed ${prefix})
    foreach(file IN ITEMS include/roomseg/roomseg.h include/roomseg/plan.h
            ${LIBDIR}/libroomseg.a ${LIBDIR}/pkgconfig/roomseg.pc
            ${LIBDIR}/cmake/roomseg/roomseg-config.cmake)
        if(NOT EXISTS ${prefix}/${file})
            message(FATAL_ERROR "not installed: ${file}")
        endif()
    endforeach()
endfunction()

function(build_with_cmake source)
    must(${CMAKE_COMMAND} -S ${source} -B ${WORK}/build -DCMAKE_C_COMPILER=${CC}
         "-DCMAKE_C_FLAGS=${FLAGS}" -DEXAMPLE=${EXAMPLE} ${ARGN})
    must(${CMAKE_COMMAND} --build ${WORK}/build)
    set(program ${WORK}/build/firmware PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK})
if(WAY STREQUAL "find_package")
    install_and_move()
    build_with_cmake(${SOURCE}/tests/package/consumer -DCMAKE_PREFIX_PATH=${prefix})
elseif(WAY STREQUAL "pkg_config")
    install_and_move()
    set(ENV{PKG_CONFIG_PATH} ${prefix}/${LIBDIR}/pkgconfig)
    must(pkg-config --exact-version=${VERSION} roomseg)
    must(pkg-config --cflags --libs roomseg)
    string(STRIP "${output}" from_pc)
    separate_arguments(from_pc UNIX_COMMAND "${from_pc}")
    separate_arguments(flags UNIX_COMMAND "${FLAGS}")
    set(program ${WORK}/firmware)
    must(${CC} -std=c99 ${flags} ${EXAMPLE} ${from_pc} -o ${program})
elseif(WAY STREQUAL "subproject")
    build_with_cmake(${SOURCE}/tests/package/subproject -DROOMSEG_SOURCE=${SOURCE})
else()
    message(FATAL_ERROR "WAY=${WAY}")
endif()

must(${program})
if(NOT output MATCHES "^room 1: [0-9]+ cm2, centre [0-9]+, [0-9]+\nroom 2: .*\n$")
    message(FATAL_ERROR "the example printed:\n${output}")
endif()
