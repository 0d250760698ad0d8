package org.sami.house.android

import javax.inject.Inject
import java.nio.file.Files
import java.nio.file.attribute.PosixFilePermissions
import org.gradle.api.DefaultTask
import org.gradle.api.GradleException
import org.gradle.api.file.DirectoryProperty
import org.gradle.api.file.RegularFileProperty
import org.gradle.api.provider.Property
import org.gradle.api.tasks.Input
import org.gradle.api.tasks.InputDirectory
import org.gradle.api.tasks.Internal
import org.gradle.api.tasks.OutputFile
import org.gradle.api.tasks.PathSensitive
import org.gradle.api.tasks.PathSensitivity
import org.gradle.api.tasks.TaskAction
import org.gradle.process.ExecOperations

/** Joins resources and classes to an APK, aligns and signs it, and has the signature and the size checked: an APK that fails is removed. */
abstract class ApkTask extends DefaultTask {
    private static final String ALIAS = 'boat'

    @InputDirectory
    @PathSensitive(PathSensitivity.RELATIVE)
    abstract DirectoryProperty getArchive()

    @InputDirectory
    @PathSensitive(PathSensitivity.RELATIVE)
    abstract DirectoryProperty getDex()

    @Input
    abstract Property<Integer> getOldestApi()

    /** Most bytes of the APK. */
    @Input
    abstract Property<Long> getMostBytes()

    /** The key store (PKCS 12) of the signing key; made where it is missing. A phone takes a newer version only from the same key. */
    @Internal
    abstract RegularFileProperty getKeyStore()

    @Internal
    abstract Property<String> getPassword()

    @OutputFile
    abstract RegularFileProperty getApk()

    @Inject
    abstract ExecOperations getStarter()

    @TaskAction
    void make() {
        def out = apk.get().asFile
        def unaligned = new File(temporaryDir, 'unaligned.apk')
        def unsigned = new File(temporaryDir, 'unsigned.apk')
        unaligned.bytes = archive.file('resources.apk').get().asFile.bytes
        run(dex.get().asFile, ['aapt', 'add', unaligned] + dex.get().asFile.list().findAll { it.endsWith('.dex') }.sort())
        run(temporaryDir, ['zipalign', '-f', '4', unaligned, unsigned])
        makeKey()
        run(temporaryDir, ['apksigner', 'sign', '--ks', keyStore.get().asFile, '--ks-key-alias', ALIAS, '--ks-pass', 'env:KEY_PASSWORD',
            '--min-sdk-version', oldestApi.get(), '--out', out, unsigned])
        try {
            run(temporaryDir, ['apksigner', 'verify', '--min-sdk-version', oldestApi.get(), out])
            if (out.length() > mostBytes.get()) {
                throw new GradleException("$out has ${out.length()} bytes, more than ${mostBytes.get()}")
            }
        } catch (Exception e) {
            out.delete()
            throw e
        }
        logger.lifecycle("$out: ${out.length()} bytes, signed with ${keyStore.get().asFile}, signature verified")
    }

    private void makeKey() {
        def store = keyStore.get().asFile
        if (!store.exists()) {
            store.parentFile.mkdirs()
            run(temporaryDir, [new File(System.getProperty('java.home'), 'bin/keytool'), '-genkeypair', '-keystore', store, '-storetype', 'PKCS12',
                '-storepass:env', 'KEY_PASSWORD', '-alias', ALIAS, '-keyalg', 'RSA', '-keysize', '3072', '-validity', '10000',
                '-dname', 'CN=SAMI boat app built on one machine'])
            if (store.toPath().fileSystem.supportedFileAttributeViews().contains('posix')) {
                Files.setPosixFilePermissions(store.toPath(), PosixFilePermissions.fromString('rw-------'))
            }
        }
    }

    private void run(File folder, List<?> command) {
        def said = new ByteArrayOutputStream()
        def result = starter.exec {
            commandLine command
            workingDir = folder
            environment 'KEY_PASSWORD', password.get()
            standardOutput = said
            errorOutput = said
            ignoreExitValue = true
        }
        if (result.exitValue != 0) {
            throw new GradleException("${command[0]} ${command[1]} failed:\n${said.toString('UTF-8')}")
        }
    }
}
