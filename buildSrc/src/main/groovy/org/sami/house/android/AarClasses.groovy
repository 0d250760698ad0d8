package org.sami.house.android

import java.util.zip.ZipFile
import org.gradle.api.artifacts.transform.InputArtifact
import org.gradle.api.artifacts.transform.TransformAction
import org.gradle.api.artifacts.transform.TransformOutputs
import org.gradle.api.artifacts.transform.TransformParameters
import org.gradle.api.file.FileSystemLocation
import org.gradle.api.provider.Provider

/** Takes the classes out of an Android archive, so that a test on the JVM can use them. */
abstract class AarClasses implements TransformAction<TransformParameters.None> {
    @InputArtifact
    abstract Provider<FileSystemLocation> getInputArtifact()

    @Override
    void transform(TransformOutputs outputs) {
        def archive = inputArtifact.get().asFile
        def jar = outputs.file(archive.name.replace('.aar', '.jar'))
        new ZipFile(archive).withCloseable { zip -> jar.bytes = zip.getInputStream(zip.getEntry('classes.jar')).bytes }
    }
}
