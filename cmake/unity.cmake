# Target `unity`: the ThrowTheSwitch test framework. Taken from, in this order:
#   1. UNITY_DIR, a folder with unity.c (or src/unity.c);
#   2. build/unity, where tools/setup.sh puts it;
#   3. the upstream release, tried once in a build folder.
# Leaves the target undefined when there is none of them.
include(${CMAKE_CURRENT_LIST_DIR}/unity_upstream.cmake)

set(UNITY_DIR "$ENV{UNITY_DIR}" CACHE PATH "Folder with Unity's unity.c and unity.h")

function(roomseg_find_unity)
    set(fetched_dir ${PROJECT_BINARY_DIR}/unity)
    if(UNITY_DIR)
        set(candidates ${UNITY_DIR} ${UNITY_DIR}/src)
    else()
        set(candidates ${PROJECT_SOURCE_DIR}/build/unity ${fetched_dir})
    endif()
    foreach(dir IN LISTS candidates)
        if(EXISTS ${dir}/unity.c AND EXISTS ${dir}/unity.h)
            roomseg_add_unity(${dir})
            return()
        endif()
    endforeach()
    if(UNITY_DIR)
        message(WARNING "UNITY_DIR=${UNITY_DIR} holds no unity.c")
    elseif(NOT ROOMSEG_UNITY_OUT_OF_REACH)
        message(STATUS "Fetching Unity ${ROOMSEG_UNITY_VERSION} (at most 20 s)")
        roomseg_fetch_unity(${fetched_dir} fetched)
        if(fetched)
            roomseg_add_unity(${fetched_dir})
        else()
            set(ROOMSEG_UNITY_OUT_OF_REACH TRUE CACHE INTERNAL "Not tried again in this folder")
        endif()
    endif()
endfunction()

function(roomseg_add_unity dir)
    message(STATUS "Unity: ${dir}")
    add_library(unity STATIC EXCLUDE_FROM_ALL ${dir}/unity.c)
    target_include_directories(unity SYSTEM PUBLIC ${dir})
    target_compile_definitions(unity PUBLIC UNITY_INCLUDE_DOUBLE UNITY_SUPPORT_64)
    if(CMAKE_C_COMPILER_ID MATCHES "GNU|Clang")
        target_compile_options(unity PRIVATE -w)
    endif()
endfunction()
