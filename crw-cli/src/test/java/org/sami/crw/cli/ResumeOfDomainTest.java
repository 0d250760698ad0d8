package org.sami.crw.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A resumed run compares its plan and its words with those of its own domain. */
class ResumeOfDomainTest {
    private static final Path UAV = Path.of("../domain-config/src/main/resources/org/sami/domain/uav");

    @TempDir
    Path folder;

    private Path begun(String domain, String plan) {
        Path journal = folder.resolve("a.journal");
        CommandResult ran = CommandResult.crw(
                "run", "--domain", domain, plan, "--speed", "max", "--for", "10", "--journal", journal.toString());
        assertThat(journal).as(ran.err()).exists();
        return journal;
    }

    private static String resumed(Path journal) {
        return CommandResult.crw("resume", journal.toString(), "--for", "20").err();
    }

    private Path copy() throws IOException {
        Path copy = folder.resolve("domain");
        try (Stream<Path> files = Files.walk(UAV)) {
            files.forEach(file -> {
                try {
                    Files.copy(file, copy.resolve(UAV.relativize(file).toString()));
                } catch (IOException e) {
                    throw new UncheckedIOException(e);
                }
            });
        }
        return copy;
    }

    @ParameterizedTest
    @CsvSource({"uav,look", "uav,search", "team,scout-and-sample", "crw,clv"})
    void runOfADomainThatShipsDiffersInNothing(String domain, String plan) {
        assertThat(resumed(begun(domain, plan))).contains("going through").doesNotContain("differs now");
    }

    @Test
    void runOfADomainInAFolderNamesTheFilesThatDifferNow() throws IOException {
        Path domain = copy();
        Path journal = begun(domain.toString(), "look");

        assertThat(resumed(journal)).contains("going through").doesNotContain("differs now");

        Path tasks = domain.resolve("tasks.json");
        Files.writeString(tasks, Files.readString(tasks) + "\n");

        assertThat(differing(journal)).containsExactly("crw: tasks.json");
    }

    @Test
    void runOfADomainWhoseFolderIsGoneNamesAllItsFiles() throws IOException {
        Path domain = copy();
        Path journal = begun(domain.toString(), "look");
        Files.move(domain, folder.resolve("elsewhere"));

        assertThat(differing(journal)).contains("crw: look", "crw: domain.json", "crw: events.json");
    }

    private static List<String> differing(Path journal) {
        return resumed(journal)
                .lines()
                .filter(line -> line.contains(" differs now"))
                .map(line -> line.substring(0, line.indexOf(" differs now")))
                .toList();
    }
}
