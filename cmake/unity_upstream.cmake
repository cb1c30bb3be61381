# Fetches the Unity release that the tests are written for into a folder, in seconds or not at all.
#
#   roomseg_fetch_unity(FOLDER RESULT)          as a function; RESULT is TRUE or FALSE
#   cmake -DUNITY_TO=FOLDER -P unity_upstream.cmake    as a script; fails when it cannot
#
# FetchContent is not used for it because there a machine without a way out stops the whole
# configuration; here it is a result like any other.
set(ROOMSEG_UNITY_VERSION 2.6.1)
set(ROOMSEG_UNITY_SHA256 b41a66d45a6b99758fb3202ace6178177014d52fc524bf1f72687d93e9867292)

function(roomseg_fetch_unity folder result)
    set(${result} FALSE PARENT_SCOPE)
    set(url https://github.com/ThrowTheSwitch/Unity/archive/refs/tags)
    set(work ${folder}.part)
    file(REMOVE_RECURSE ${work})
    file(DOWNLOAD ${url}/v${ROOMSEG_UNITY_VERSION}.tar.gz ${work}/unity.tar.gz
         TIMEOUT 20 INACTIVITY_TIMEOUT 5 STATUS status)
    list(GET status 0 code)
    if(code EQUAL 0)
        file(SHA256 ${work}/unity.tar.gz sum)
        if(sum STREQUAL ROOMSEG_UNITY_SHA256)
            execute_process(COMMAND ${CMAKE_COMMAND} -E tar xzf unity.tar.gz
                            WORKING_DIRECTORY ${work})
            file(MAKE_DIRECTORY ${folder})
            file(GLOB sources ${work}/Unity-${ROOMSEG_UNITY_VERSION}/src/unity*)
            file(COPY ${sources} ${work}/Unity-${ROOMSEG_UNITY_VERSION}/LICENSE.txt
                 DESTINATION ${folder})
            set(${result} TRUE PARENT_SCOPE)
        else()
            message(WARNING "Unity ${ROOMSEG_UNITY_VERSION}: the download has the wrong SHA-256")
        endif()
    endif()
    file(REMOVE_RECURSE ${work})
endfunction()

if(CMAKE_SCRIPT_MODE_FILE STREQUAL CMAKE_CURRENT_LIST_FILE)
    roomseg_fetch_unity(${UNITY_TO} fetched)
    if(NOT fetched)
        message(FATAL_ERROR "Unity ${ROOMSEG_UNITY_VERSION} cannot be downloaded from here")
    endif()
endif()
