package org.sami.house.typescript

import org.gradle.api.file.FileCollection
import org.gradle.api.tasks.Classpath
import org.gradle.process.CommandLineArgumentProvider

/** Tells tests where the compiler is: the system property {@code typescript.compiler} is its class path. */
class CompilerOfTests implements CommandLineArgumentProvider {
    @Classpath
    final FileCollection compiler

    CompilerOfTests(FileCollection compiler) {
        this.compiler = compiler
    }

    @Override
    Iterable<String> asArguments() {
        ["-Dtypescript.compiler=$compiler.asPath".toString()]
    }
}
