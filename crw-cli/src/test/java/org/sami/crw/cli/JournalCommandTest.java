package org.sami.crw.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A journal shows what its session knew after any entry. */
class JournalCommandTest {
    @TempDir
    static Path folder;

    private static String journal;

    @BeforeAll
    static void runForAWhile() {
        journal = folder.resolve("clv.journal").toString();
        CommandResult ran = CommandResult.crw("run", "clv", "--speed", "max", "--for", "60", "--journal", journal);
        assertThat(ran.exitCode()).isEqualTo(5);
    }

    @Test
    void lastStateSaysWhereTheBoatsAreAndWhyNothingFires() {
        CommandResult ran = CommandResult.crw("journal", journal);

        assertThat(ran.exitCode()).isZero();
        assertThat(ran.out())
                .contains("robots: boat1, boat2, boat3")
                .contains("Execute paths: ")
                .contains("It waits for Proxy Path Completed")
                .contains("cannot fire");
    }

    @Test
    void earlierStateIsTheOneOfThatEntry() {
        String first = CommandResult.crw("journal", journal, "--at", "0").out();

        assertThat(first).contains("entry 0 of").contains("robots: none").contains("no mission runs");

        String asked = CommandResult.crw("journal", journal, "--at", entryOf("start-mission"))
                .out();
        assertThat(asked).contains("Select boats: ").contains("decision 1 of mission 1");
    }

    @Test
    void entriesAreListedInOrder() {
        assertThat(CommandResult.crw("journal", journal, "--entries").out())
                .contains("1  ")
                .contains("clv");
        assertThat(CommandResult.crw("journal", journal, "--entries", "--at", "2")
                        .out()
                        .lines())
                .hasSize(2);
    }

    @Test
    void entryThatIsNotThereIsRefused() {
        CommandResult ran = CommandResult.crw("journal", journal, "--at", "9999");

        assertThat(ran.exitCode()).isEqualTo(2);
        assertThat(ran.err()).contains("--at is 0 to ").contains("not 9999");
    }

    @Test
    void globalsOfASessionBecomeInitialValuesOfAProjectsFile() throws IOException {
        Path project = folder.resolve("lake.json");
        CommandResult made = CommandResult.crw("new", project.toString());
        assertThat(made.exitCode()).isZero();
        String text = Files.readString(project);
        Files.writeString(
                project,
                text.replaceFirst(
                        "\"plans\":",
                        "\"globals\": [{\"name\": \"@depth\", \"type\": \"real\", \"initial\": 2.5},"
                                + " {\"name\": \"@count\", \"type\": \"integer\"}],\n  \"plans\":"));
        String session = folder.resolve("globals.journal").toString();
        CommandResult ran = CommandResult.crw(
                "run", project.toString(), "--speed", "max", "--set", "@depth=4", "--for", "30", "--journal", session);
        assertThat(ran.err()).as("run").doesNotContain("error");

        CommandResult saved = CommandResult.crw("journal", session, "--save-globals", project.toString());

        assertThat(saved.err()).isEmpty();
        assertThat(saved.exitCode()).isZero();
        assertThat(saved.out()).contains("@depth: 4, before 2.5").contains("1 of 1 globals changed");
        assertThat(Files.readString(project)).contains("\"@depth\", \"type\": \"real\", \"initial\": 4");
        assertThat(CommandResult.crw("check", project.toString()).exitCode()).isZero();

        Files.writeString(project, Files.readString(project).replace("\"real\", \"initial\": 4", "\"text\""));
        String before = Files.readString(project);
        CommandResult refused = CommandResult.crw("journal", session, "--save-globals", project.toString());
        assertThat(refused.exitCode()).isEqualTo(1);
        assertThat(refused.err()).contains("@depth").contains("nothing was saved");
        assertThat(project).hasContent(before);
    }

    @Test
    void listingAndSavingAtOnceIsRefused() {
        CommandResult ran = CommandResult.crw("journal", journal, "--entries", "--save-globals", "x.json");

        assertThat(ran.exitCode()).isEqualTo(2);
        assertThat(ran.err()).contains("--entries").contains("--save-globals");
    }

    private static String entryOf(String kind) {
        return CommandResult.crw("journal", journal, "--entries")
                .out()
                .lines()
                .filter(line -> line.contains(kind))
                .map(line -> line.substring(0, line.indexOf(' ')))
                .findFirst()
                .orElseThrow(() -> new AssertionError("no entry of " + kind));
    }
}
