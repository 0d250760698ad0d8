package org.sami.crw.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.RandomAccessFile;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import picocli.CommandLine;

/** Files that are larger than any memory, or have no end, are refused by name with exit code 2; they are sparse, and take no room. */
class OversizedFileTest {
    private static final long GIGABYTE = 1L << 30;

    @TempDir
    Path folder;

    private Path large(String name) throws IOException {
        Path file = folder.resolve(name);
        try (RandomAccessFile made = new RandomAccessFile(file.toFile(), "rw")) {
            made.setLength(GIGABYTE);
        }
        return file;
    }

    private static void assertRefused(Path file, CommandResult ran) {
        assertThat(ran.err()).contains(file + " is larger than ").contains(" MB, and is not read");
        assertThat(ran.exitCode()).isEqualTo(2);
    }

    @Test
    void projectOfAGigabyteIsRefusedByEveryCommandThatReadsOne() throws Exception {
        Path project = large("project.json");

        for (String command : List.of("check", "run", "session", "test")) {
            assertRefused(project, CommandResult.crw(command, project.toString()));
        }
    }

    @Test
    void projectFolderWithAGigabyteIsRefused() throws Exception {
        Path project = large("project.json");

        assertRefused(project, CommandResult.crw("check", folder.toString()));
    }

    @Test
    void domainOfAGigabyteIsRefused() throws Exception {
        Path events = large("events.json");
        Files.writeString(folder.resolve("domain.json"), "{\"domain\": \"lake\", \"files\": [\"events.json\"]}");

        assertRefused(events, CommandResult.crw("check", "--domain", folder.toString()));
    }

    @Test
    void locationsOfAGigabyteAreRefused() throws Exception {
        Path locations = large("locations.txt");

        assertRefused(locations, CommandResult.crw("import-locations", locations.toString()));
    }

    @Test
    void answersAndRunsOfAGigabyteAreRefused() throws Exception {
        Path answers = large("answers.json");
        assertRefused(answers, CommandResult.crw("run", "clv", "--answers", answers.toString()));

        Path runs = large("runs");
        assertRefused(runs, CommandResult.crw("experiment", "--runs", runs.toString()));
    }

    @Test
    void projectOfTheEarlierSystemOfAGigabyteIsRefused() throws Exception {
        Path project = large("earlier.json");

        CommandResult ran = CommandResult.crw(
                "import-legacy", project.toString(), folder.resolve("made.json").toString());
        assertRefused(project, ran);
    }

    @Test
    @EnabledOnOs({OS.LINUX, OS.MAC})
    void deviceWithoutAnEndIsRefusedAsConfigurationAndAsScript() {
        StringWriter err = new StringWriter();
        CommandLine line = Crw.commandLine().setErr(new PrintWriter(err));
        int code = Crw.execute(line, Map.of(), "--config", "/dev/zero", "plans");
        assertRefused(Path.of("/dev/zero"), new CommandResult(code, "", err.toString()));

        CommandResult scripted = CommandResult.crw("session", "--script", "/dev/zero");
        assertThat(scripted.err())
                .contains("--script: /dev/zero: a line of more than 1000000 characters is no command");
        assertThat(scripted.exitCode()).isEqualTo(2);
    }
}
