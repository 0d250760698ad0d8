package org.sami.house.android

import javax.inject.Inject
import org.gradle.api.DefaultTask
import org.gradle.api.GradleException
import org.gradle.api.file.DirectoryProperty
import org.gradle.api.file.FileSystemOperations
import org.gradle.api.file.RegularFileProperty
import org.gradle.api.provider.Property
import org.gradle.api.tasks.Input
import org.gradle.api.tasks.InputDirectory
import org.gradle.api.tasks.InputFile
import org.gradle.api.tasks.OutputDirectory
import org.gradle.api.tasks.PathSensitive
import org.gradle.api.tasks.PathSensitivity
import org.gradle.api.tasks.TaskAction
import org.gradle.process.ExecOperations

/**
 * Makes an app's class R and, by aapt, the archive of its manifest, resources and assets. Where the tools are not installed, R comes without values, there is
 * no archive, and one line says so.
 */
abstract class ResourcesTask extends DefaultTask {
    @InputFile
    @PathSensitive(PathSensitivity.NONE)
    abstract RegularFileProperty getManifest()

    @InputDirectory
    @PathSensitive(PathSensitivity.RELATIVE)
    abstract DirectoryProperty getResources()

    @InputDirectory
    @PathSensitive(PathSensitivity.RELATIVE)
    abstract DirectoryProperty getAssets()

    @Input
    abstract Property<String> getJavaPackage()

    @Input
    abstract Property<String> getVersionName()

    @Input
    abstract Property<Integer> getVersionCode()

    /** What of the tools is missing: another answer makes other output. */
    @Input
    List<String> getMissing() {
        AndroidTools.missing()
    }

    @OutputDirectory
    abstract DirectoryProperty getSources()

    /** The folder of the archive {@code resources.apk}. */
    @OutputDirectory
    abstract DirectoryProperty getArchive()

    @Inject
    abstract ExecOperations getStarter()

    @Inject
    abstract FileSystemOperations getFiles()

    @TaskAction
    void make() {
        files.delete { it.delete(sources, archive) }
        [sources, archive].each { it.get().asFile.mkdirs() }
        def r = new File(sources.get().asFile, javaPackage.get().replace('.', '/') + '/R.java')
        def names = new ResourceNames(resources.get().asFile)
        if (missing) {
            logger.warn("$path: ${AndroidTools.line(missing)}")
            r.parentFile.mkdirs()
            r.setText(names.source(javaPackage.get()), 'UTF-8')
            return
        }
        starter.exec {
            commandLine 'aapt', 'package', '-f', '-m', '--non-constant-id', '-J', sources.get().asFile, '-M', manifest.get().asFile,
                '-S', resources.get().asFile, '-A', assets.get().asFile, '-I', AndroidTools.FRAMEWORK,
                '--version-code', versionCode.get(), '--version-name', versionName.get(),
                '-F', archive.file('resources.apk').get().asFile
        }
        if (ResourceNames.declared(r) != names.byKind()) { // else the app would not compile where aapt is missing
            throw new GradleException("of the resources aapt names ${ResourceNames.declared(r)}, ResourceNames ${names.byKind()}")
        }
    }
}
