# What every target of this project is compiled with. Nothing of it reaches a target that links
# roomseg::roomseg, except the sanitizers' run-time library, which a static library needs there.
function(roomseg_compile_options target)
    set_target_properties(${target} PROPERTIES
        C_STANDARD 99
        C_STANDARD_REQUIRED ON
        C_EXTENSIONS OFF
    )
    if(CMAKE_C_COMPILER_ID MATCHES "GNU|Clang")
        target_compile_options(${target} PRIVATE
            -Wall -Wextra -Wconversion -Wshadow -Wvla -Wstrict-prototypes -Wmissing-prototypes)
        if(ROOMSEG_WERROR)
            target_compile_options(${target} PRIVATE -Werror)
        endif()
    elseif(MSVC)
        target_compile_options(${target} PRIVATE /W4)
        if(ROOMSEG_WERROR)
            target_compile_options(${target} PRIVATE /WX)
        endif()
    endif()
    if(ROOMSEG_SANITIZE)
        target_compile_options(${target} PRIVATE
            -fsanitize=${ROOMSEG_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
        target_link_libraries(${target} PUBLIC -fsanitize=${ROOMSEG_SANITIZE})
    endif()
endfunction()
