package org.sami.crw.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Plans of another domain than the boats', named or as a folder, are checked, tested, drawn and shown with its words. */
class DomainOptionTest {
    private static final String FOLDER = "../domain-config/src/main/resources/org/sami/domain/uav";

    @TempDir
    Path folder;

    @Test
    void domainThatShipsIsNamed() throws Exception {
        Path svg = folder.resolve("search.svg");

        assertThat(CommandResult.crw("check", "--domain", "uav").out()).isEqualTo("uav: 0 errors, 0 warnings\n");
        assertThat(CommandResult.crw("test", "--domain", "uav", "search").out()).contains("search: 9 passed, 0 failed");
        assertThat(CommandResult.crw("phases", "--domain", "uav", "search", "--choose", "Nothing seen")
                        .out())
                .contains("Search: Target seen | Nothing seen (shown) | It cannot | It is lost")
                .doesNotContain("[Confirm target]");
        assertThat(CommandResult.crw("draw", "--domain", "uav", "search", "--svg", svg.toString())
                        .exitCode())
                .isZero();
        assertThat(Files.readString(svg)).contains("Operator chooses");
    }

    @Test
    void plansOfADomainAreListed() {
        CommandResult named = CommandResult.crw("plans", "--domain", "uav");
        CommandResult inFolder = CommandResult.crw("plans", "--domain", FOLDER, "search-area");

        assertThat(named.exitCode()).as(named.err()).isZero();
        assertThat(named.out())
                .contains("search  (", "--set fly-there.speed=real  (8)", "--interrupt copters home@SECONDS")
                .doesNotContain("clv");
        assertThat(inFolder.out()).startsWith("search-area  (").doesNotContain("two-look-closer");
        assertThat(CommandResult.crw("plans", "--domain", "team").out()).contains("scout-and-sample");
    }

    @Test
    void runOfCoptersSpeaksOfNoBoat() {
        CommandResult ran =
                CommandResult.crw("run", "--domain", "uav", "first-flight", "--boats", "2", "--speed", "max");

        assertThat(ran.err()).contains("running first-flight: copters 2,").doesNotContain("boat", "quay");
        assertThat(ran.out()).contains("copter2").doesNotContain("boat", "quay");
    }

    @Test
    void experimentOfCoptersRuns() {
        CommandResult ran = CommandResult.crw(
                "experiment",
                "--domain",
                "uav",
                "first-flight",
                "--boats",
                "2",
                "--seeds",
                "1..2",
                "--conditions",
                "calm");

        assertThat(ran.exitCode()).as(ran.err()).isZero();
        assertThat(ran.err()).contains("2 of 2 runs ended");
        assertThat(ran.out()).contains("first-flight").doesNotContain("boat");
    }

    @Test
    void experimentOfASearchCountsTheTargetsThatWereSeen() {
        CommandResult ran = CommandResult.crw(
                "experiment",
                "--domain",
                "uav",
                "search",
                "--boats",
                "3",
                "--locations",
                "12",
                "--seeds",
                "1",
                "--conditions",
                "calm");

        assertThat(ran.exitCode()).as(ran.err()).isZero();
        assertThat(ran.out()).containsPattern("empty  targets\nsearch .* 12/12 .* [1-9][0-9]*\n");
    }

    @Test
    void domainOfAFolderIsTakenFromThere() {
        CommandResult tested = CommandResult.crw("test", "--domain", FOLDER, "search");
        CommandResult shown = CommandResult.crw("phases", "--domain", FOLDER, "search");

        assertThat(tested.exitCode()).as(tested.err()).isZero();
        assertThat(shown.out()).contains("Task assignment").contains("then Task execution");
    }

    @Test
    void unknownDomainIsAMistakeInUsage() {
        for (String command : new String[] {"plans", "check", "test", "phases"}) {
            CommandResult ran = CommandResult.crw(command, "--domain", "uavs", "search");

            assertThat(ran.exitCode()).isEqualTo(2);
            assertThat(ran.err()).contains("--domain: there is no folder 'uavs', nor does such a domain come with crw");
        }
    }

    @Test
    void domainWithMistakesIsToldByEachCommand() throws Exception {
        Files.writeString(
                folder.resolve("domain.json"),
                "{\"formatVersion\": 1, \"domain\": \"kite\", \"files\": [\"no.json\"]}");

        for (String command : new String[] {"plans", "test", "phases"}) {
            CommandResult ran = CommandResult.crw(command, "--domain", folder.toString(), "search");

            assertThat(ran.exitCode()).isEqualTo(1);
            assertThat(ran.err()).contains("no.json");
        }
    }
}
