package org.sami.crw.cli.analysis;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.crw.cli.CommandResult;

class AnalyseAllCommandTest {
    @TempDir
    Path folder;

    @Test
    void tableHasARowForEachPlanAndNumberOfBoats() {
        CommandResult ran = CommandResult.crw("analyse-all", "pull-out", "look-around", "--boats", "1,2");

        assertThat(ran.exitCode()).as(ran.err()).isZero();
        assertThat(ran.out().lines().filter(line -> line.startsWith("| `")))
                .hasSize(4)
                .allMatch(line -> line.contains("| no | yes | – | – |"));
        assertThat(ran.out())
                .contains("| `pull-out` | 1 | ")
                .contains("| `look-around` | 2 | ")
                .contains("4 rows in ");
    }

    @Test
    void whatOnlyTheNetDoesIsNotCertainAndNoFault() {
        CommandResult ran = CommandResult.crw("analyse-all", "add-simulated-boats", "--boats", "1");

        assertThat(ran.exitCode()).as(ran.err()).isZero();
        assertThat(ran.out()).contains("| yes, not certain | no, not certain |").contains("it may be so");
    }

    @Test
    void plansThatCopyBoatsAreAnsweredWithSeveral() {
        CommandResult ran =
                CommandResult.crw("analyse-all", "clv-dangerous-area", "deploy-and-station-keep", "--boats", "3,5");

        assertThat(ran.exitCode()).as(ran.out() + ran.err()).isZero();
        assertThat(ran.out().lines().filter(line -> line.startsWith("| `")))
                .hasSize(4)
                .allMatch(line -> line.contains("| no | yes | – | – |"))
                .allMatch(line -> line.contains("*†") == line.contains("`deploy-and-station-keep`"));
    }

    /** Also of each other plan that is shipped later: none is left unknown, and no saved query has another answer. */
    @Test
    void wholeLibraryIsAnsweredWithThreeAndFiveBoatsAndItsQueriesAreAsExpected() {
        CommandResult ran = CommandResult.crw("analyse-all", "--boats", "3,5");

        assertThat(ran.exitCode()).as(ran.out() + ran.err()).isZero();
        assertThat(ran.out().lines().filter(line -> line.startsWith("| `")))
                .hasSizeGreaterThan(50)
                .noneMatch(line -> line.contains("unknown"));
        for (String plan : List.of("clv", "station-keep", "clv-interrupts", "recharge", "assemble", "explore-area")) {
            assertThat(ran.out().lines().filter(line -> line.startsWith("| `" + plan + "` |")))
                    .as(plan)
                    .hasSizeGreaterThanOrEqualTo(2)
                    .allMatch(line -> line.contains("as expected"));
        }
    }

    @Test
    void subMissionsAreFollowedToADepth() {
        CommandResult open = CommandResult.crw("analyse-all", "clv-interrupts", "--boats", "1");
        CommandResult followed = CommandResult.crw("analyse-all", "clv-interrupts", "--boats", "1", "--depth", "1");

        assertThat(open.out()).contains("| `clv-interrupts` | 1 | 24, 26 | 14 | no | yes | 3 of 3 as expected | – |");
        assertThat(followed.out())
                .contains("| `clv-interrupts` | 1 | 48, 88 | 74 | no | yes | 3 of 3 as expected | – |");
        assertThat(CommandResult.crw("analyse-all", "clv-interrupts", "--depth", "6")
                        .err())
                .contains("--depth is 0 to 5, not 6");
    }

    @Test
    void numbersOfBoatsAreChecked() {
        CommandResult ran = CommandResult.crw("analyse-all", "--boats", "1,26");

        assertThat(ran.exitCode()).isEqualTo(2);
        assertThat(ran.err()).contains("--boats is 0 to 25");
    }

    @Test
    void netOfAPlanIsDrawn() throws Exception {
        Path file = folder.resolve("net.svg");

        CommandResult ran = CommandResult.crw(
                "graph", "../docs/reductions/reductions.json", "--plan", "add", "--net", file.toString());

        assertThat(ran.exitCode()).as(ran.err()).isZero();
        assertThat(Files.readString(file)).startsWith("<").contains("From: robot-1 ●");
    }
}
