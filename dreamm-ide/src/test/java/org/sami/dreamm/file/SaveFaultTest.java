package org.sami.dreamm.file;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.dreamm.document.ProjectDocument;
import org.sami.spn.json.DomainLibrary;

class SaveFaultTest {
    private static final DomainLibrary DOMAIN =
            DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();

    @TempDir
    private Path folder;

    @Test
    void aFileInPlaceOfAFolderIsSaid() throws IOException {
        Path file = Files.writeString(folder.resolve("harbour"), "");
        Path path = file.resolve("clv.json");
        ProjectFile project = new ProjectFile(
                new ProjectDocument(DOMAIN.vocabulary(), DOMAIN.projectOf("clv").orElseThrow(), Optional.empty()));

        IOException fault = catchThrowableOfType(IOException.class, () -> project.save(path));

        assertThat(SaveFault.words(path, fault)).isEqualTo(file + " is a file and no folder");
    }

    @Test
    void aMissingPermissionNamesTheFolder() {
        Path path = folder.resolve("p.json");

        assertThat(SaveFault.words(path, new AccessDeniedException(path + ".tmp")))
                .isEqualTo("you have no permission to write in " + folder);
    }

    @Test
    void aFullDiskIsSaid() {
        Path path = folder.resolve("p.json");

        assertThat(SaveFault.words(path, new FileSystemException(path + ".tmp", null, "No space left on device")))
                .startsWith("No space left on device");
    }
}
