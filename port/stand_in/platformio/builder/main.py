"""PlatformIO's build script of the platform "desk"; it runs inside of SCons."""

from SCons.Script import Default, DefaultEnvironment

env = DefaultEnvironment()
env.Replace(PROGNAME="program", AR="ar", AS="as", CC="cc", CXX="c++", RANLIB="ranlib",
            SIZETOOL="size")
Default(env.BuildProgram())
