package org.sami.dreamm.file;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.dreamm.document.ProjectDocument;
import org.sami.spn.edit.ProjectEdit;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.model.Project;

class ProjectFileTest {
    private static final DomainLibrary DOMAIN =
            DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();

    @TempDir
    private Path folder;

    private final ProjectDocument document =
            new ProjectDocument(DOMAIN.vocabulary(), DOMAIN.projectOf("clv").orElseThrow(), Optional.empty());
    private final ProjectFile file = new ProjectFile(document);

    @Test
    void whatIsSavedInAFileIsReadBackEqual() throws IOException {
        Path path = folder.resolve("clv.json");
        document.apply(new ProjectEdit.ClonePlan("clv", "copy", "Copy"));

        file.save(path);

        assertThat(document.isModified()).isFalse();
        assertThat(document.file()).contains(path);
        assertThat(file.read(path).project()).isEqualTo(document.project());
    }

    @Test
    void aFolderHasAFileForEachPlanAndLosesThoseOfPlansThatAreGone() throws IOException {
        document.apply(new ProjectEdit.ClonePlan("clv", "copy", "Copy"));
        file.save(folder);
        assertThat(folder.resolve("plans")).isDirectoryContaining("glob:**copy.json");

        document.apply(new ProjectEdit.RenamePlan("copy", "other"));
        file.save(folder);

        assertThat(folder.resolve("plans/copy.json")).doesNotExist();
        assertThat(folder.resolve("plans/other.json")).exists();
        assertThat(file.read(folder).project()).isEqualTo(document.project());
    }

    @Test
    void savingInTheFolderOfAnotherProjectDeletesNoPlanOfIt() throws IOException {
        ProjectDocument other = new ProjectDocument(
                DOMAIN.vocabulary(), DOMAIN.projectOf("station-keep").orElseThrow(), Optional.empty());
        new ProjectFile(other).save(folder);
        assertThat(folder.resolve("plans/station-keep.json")).exists();

        file.save(folder);

        assertThat(folder.resolve("plans/station-keep.json")).exists();
        assertThat(file.read(folder).project()).isEqualTo(document.project());
    }

    @Test
    void aFoldersProjectFileOpensTheFolder() throws IOException {
        file.save(folder);

        assertThat(file.read(folder.resolve("project.json")).path()).isEqualTo(folder);
    }

    @Test
    void noticesWhatAnotherProgramWrites() throws IOException {
        file.save(folder);
        assertThat(file.changedOnDisk()).isEmpty();

        Path plan = folder.resolve("plans/clv.json");
        Files.writeString(plan, Files.readString(plan).replace("Select boats", "Choose boats"));

        assertThat(file.changedOnDisk()).isPresent();
    }

    @Test
    void whatAnotherProgramWroteIsTakenAsAnEditThatCanBeTakenBack() throws IOException {
        Path path = folder.resolve("clv.json");
        file.save(path);
        document.apply(new ProjectEdit.NameProject("mine"));
        Project mine = document.project();
        Files.writeString(path, Files.readString(path).replace("Select boats", "Choose boats"));

        file.take(file.read(path));

        assertThat(document.isModified()).isFalse();
        assertThat(document.project()).isEqualTo(file.read(path).project());
        document.undo();
        assertThat(document.project()).isEqualTo(mine);
        assertThat(document.isModified()).isTrue();
    }

    @Test
    void aFileThatCannotBeReadIsRefusedInOneLineAndNothingIsLost() throws IOException {
        Path path = folder.resolve("broken.json");
        Files.writeString(path, "{\"formatVersion\": 1,\n\"id\": }");
        Project before = document.project();

        assertThatThrownBy(() -> file.read(path))
                .isInstanceOf(IOException.class)
                .hasMessageContaining("broken.json is not opened")
                .hasMessageContaining("line 2")
                .hasMessageNotContaining("\n");
        assertThat(document.project()).isSameAs(before);
    }
}
