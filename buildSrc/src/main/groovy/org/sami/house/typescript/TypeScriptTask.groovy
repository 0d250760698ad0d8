package org.sami.house.typescript

import javax.inject.Inject
import org.gradle.api.DefaultTask
import org.gradle.api.GradleException
import org.gradle.api.file.ConfigurableFileCollection
import org.gradle.api.file.DirectoryProperty
import org.gradle.api.file.FileSystemOperations
import org.gradle.api.provider.Property
import org.gradle.api.tasks.CacheableTask
import org.gradle.api.tasks.Classpath
import org.gradle.api.tasks.Input
import org.gradle.api.tasks.InputDirectory
import org.gradle.api.tasks.OutputDirectory
import org.gradle.api.tasks.PathSensitive
import org.gradle.api.tasks.PathSensitivity
import org.gradle.api.tasks.TaskAction
import org.gradle.process.ExecOperations

/** Checks TypeScript and makes modules of it that browsers take. What is wrong in the sources fails the task, with file, line and column of each fault. */
@CacheableTask
abstract class TypeScriptTask extends DefaultTask {
    /** A folder of {@code .ts} and {@code .d.ts} files, with the options in its {@code tsconfig.json}. */
    @InputDirectory
    @PathSensitive(PathSensitivity.RELATIVE)
    abstract DirectoryProperty getSources()

    /** The jars of the compiler and of the engine that runs it. */
    @Classpath
    abstract ConfigurableFileCollection getCompiler()

    /** The jar with {@link TypeScriptCompiler}, which starts it: the one on Gradle's own class path is rewritten by Gradle and runs nowhere else. */
    @Classpath
    abstract ConfigurableFileCollection getStarted()

    /** Where the modules stand in the module's resources, such as {@code org/sami/page}. */
    @Input
    abstract Property<String> getFolder()

    /** Resources, for the module's jar. */
    @OutputDirectory
    abstract DirectoryProperty getResources()

    @Inject
    abstract ExecOperations getStarter()

    @Inject
    abstract FileSystemOperations getFileSystem()

    @TaskAction
    void compile() {
        def said = new ByteArrayOutputStream()
        def into = resources.get()
        fileSystem.delete { delete(into) }
        def folderOfSources = sources.get().asFile
        def result = starter.javaexec {
            classpath = compiler + started
            mainClass = 'org.sami.house.typescript.TypeScriptCompiler'
            maxHeapSize = '640m'
            jvmArgs '-XX:+UseSerialGC'
            args folderOfSources, into.dir(folder.get()).asFile
            errorOutput = said
            ignoreExitValue = true
        }
        if (result.exitValue != 0) {
            throw new GradleException("in $folderOfSources:\n${said.toString('UTF-8')}")
        }
    }
}
