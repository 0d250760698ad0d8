package org.sami.crw.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What a command reads that is started beside a folder which has the name of a plan of the library. */
@Tag("process")
class PlanFolderTest {
    @TempDir
    private Path folder;

    @ParameterizedTest
    @CsvSource({"false, 0, 'clv: 0 errors'", "true, 1, 'error'"})
    void folderOfAPlansNameIsMeantOnlyWhereItHasAProject(boolean hasProject, int exitCode, String said)
            throws Exception {
        Path there = Files.createDirectory(folder.resolve("clv"));
        if (hasProject) {
            Files.writeString(there.resolve("project.json"), "{}");
        }

        Process crw = CrwProcess.command(folder, List.of("check", "clv"))
                .directory(folder.toFile())
                .redirectErrorStream(true)
                .start();
        String out = new String(crw.getInputStream().readAllBytes(), StandardCharsets.UTF_8);

        assertThat(crw.waitFor()).as(out).isEqualTo(exitCode);
        assertThat(out).contains(said);
    }
}
