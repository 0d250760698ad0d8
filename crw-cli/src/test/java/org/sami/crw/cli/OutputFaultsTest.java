package org.sami.crw.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assumptions.assumeThat;

import com.fasterxml.jackson.databind.ObjectMapper;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Reports that cannot be written, or would replace others. */
class OutputFaultsTest {
    /** A device of Linux on which there is never room. */
    private static final Path FULL = Path.of("/dev/full");

    @TempDir
    Path folder;

    @Test
    @Tag("process")
    void fullStandardOutputIsNamedAndIsAFailure() throws Exception {
        assumeThat(FULL).exists();
        Process process = CrwProcess.command(folder, List.of("plans"))
                .redirectOutput(FULL.toFile())
                .start();

        String err = new String(process.getErrorStream().readAllBytes(), StandardCharsets.UTF_8);

        assertThat(process.waitFor()).isEqualTo(4);
        assertThat(err).contains("crw: standard output could not be written");
    }

    @Test
    void reportIsPrintedThoughTheDiskOfItsFolderIsFull() throws Exception {
        assumeThat(FULL).exists();
        Path reports = Files.createDirectory(folder.resolve("out"));
        Files.createSymbolicLink(reports.resolve("boats.csv.new"), FULL);

        CommandResult ran = run("--report", reports.toString());

        assertThat(ran.out()).contains("outcome             ended");
        assertThat(ran.err()).contains("crw: the report could not be written to " + reports);
        assertThat(ran.exitCode()).isEqualTo(4);
    }

    @Test
    void reportThatIsThereIsNotReplacedUnasked() throws Exception {
        Path reports = Files.createDirectory(folder.resolve("out"));
        Path earlier = Files.writeString(reports.resolve("tracks.csv"), "yesterday's");

        CommandResult ran = run("--report", reports.toString());

        assertThat(ran.exitCode()).isEqualTo(2);
        assertThat(ran.err()).contains("tracks.csv").contains("--overwrite");
        assertThat(earlier).hasContent("yesterday's");
        assertThat(reports).isDirectoryNotContaining("glob:**report.json");
    }

    @Test
    void reportIsReplacedWhereThatIsAskedAndSaysSo() throws Exception {
        Path reports = folder.resolve("out");
        run("--report", reports.toString());

        CommandResult ran = run("--seed", "2", "--report", reports.toString(), "--overwrite");

        assertThat(ran.exitCode()).isZero();
        assertThat(ran.err()).contains("the report in " + reports + " will be replaced");
        assertThat(new ObjectMapper()
                        .readTree(reports.resolve("report.json").toFile())
                        .get("seed")
                        .asInt())
                .isEqualTo(2);
    }

    @Test
    void overwritingWithoutAReportIsWrongUsage() {
        assertThat(run("--overwrite").exitCode()).isEqualTo(2);
    }

    private static CommandResult run(String... more) {
        List<String> args = new ArrayList<>(
                List.of("run", "clv", "--boats", "1", "--locations", "1", "--area", "50", "--speed", "max"));
        args.addAll(List.of(more));
        return CommandResult.crw(args.toArray(String[]::new));
    }
}
