package org.sami.house.android

import javax.inject.Inject
import org.gradle.api.DefaultTask
import org.gradle.api.GradleException
import org.gradle.api.file.ConfigurableFileCollection
import org.gradle.api.file.DirectoryProperty
import org.gradle.api.provider.Property
import org.gradle.api.tasks.Classpath
import org.gradle.api.tasks.Input
import org.gradle.api.tasks.OutputDirectory
import org.gradle.api.tasks.TaskAction
import org.gradle.process.ExecOperations

/**
 * Compiles classes for a phone with D8, which rewrites what the phone's oldest API level does not know. Whatever D8 warns of, it cannot rewrite: the task
 * fails with it.
 */
abstract class DexTask extends DefaultTask {
    @Classpath
    abstract ConfigurableFileCollection getClasses()

    /** The jar of D8. */
    @Classpath
    abstract ConfigurableFileCollection getCompiler()

    /** Classes of the framework at the oldest API level. */
    @Classpath
    abstract ConfigurableFileCollection getFramework()

    @Input
    abstract Property<Integer> getOldestApi()

    @OutputDirectory
    abstract DirectoryProperty getDex()

    @Inject
    abstract ExecOperations getStarter()

    @TaskAction
    void compile() {
        def said = new ByteArrayOutputStream()
        def jars = classes.files.findAll { it.name.endsWith('.jar') }
        def result = starter.javaexec {
            classpath = compiler
            mainClass = 'com.android.tools.r8.D8'
            maxHeapSize = '1g'
            args '--release', '--min-api', oldestApi.get(), '--output', dex.get().asFile, '--lib', System.getProperty('java.home')
            framework.files.each { args '--lib', it }
            args jars
            errorOutput = said
            ignoreExitValue = true
        }
        def text = said.toString('UTF-8')
        if (result.exitValue != 0 || text.contains('Warning')) {
            throw new GradleException("D8 cannot make these classes ready for API ${oldestApi.get()}:\n$text")
        }
    }
}
