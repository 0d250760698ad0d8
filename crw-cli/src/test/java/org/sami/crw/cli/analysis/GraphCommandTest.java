package org.sami.crw.cli.analysis;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.crw.cli.CommandResult;

class GraphCommandTest {
    @TempDir
    Path folder;

    @Test
    void graphOfAFileIsDrawnWithEachStateAndFiring() throws IOException {
        String file = folder.resolve("p2.pnml").toString();
        assertThat(CommandResult.crw("analyse", "philosophers-2", "--write", file)
                        .exitCode())
                .isZero();
        Path svg = folder.resolve("new folder/p2.svg");

        CommandResult ran = CommandResult.crw("graph", file, "--svg", svg.toString());

        assertThat(ran.exitCode()).as(ran.err()).isZero();
        assertThat(ran.out().lines())
                .containsExactly("philosophers-2 (10 places, 10 transitions)", "all 9 states", "written to " + svg);
        assertThat(Files.readString(svg))
                .contains("fork0 thinks0 fork1 thinks1", "takeLeft0", "6 · deadlock", "7 · deadlock", "all 9 states");
    }

    @Test
    void graphThatIsCutSaysSo() throws IOException {
        Path dot = folder.resolve("p5.dot");

        CommandResult ran = CommandResult.crw("graph", "philosophers-5", "--states", "40", "--dot", dot.toString());

        assertThat(ran.exitCode()).isEqualTo(5);
        assertThat(ran.out())
                .contains("the nearest 40 states, ")
                .contains("bounded search only, as the budget of states");
        assertThat(Files.readString(dot)).contains("dashed").contains("bounded search only");
    }

    @Test
    void symmetryDrawsOneOfStatesThatAreAlike() throws IOException {
        Path dot = folder.resolve("sm.dot");

        CommandResult ran = CommandResult.crw("graph", "shared-memory-3", "--symmetry", "--dot", dot.toString());

        assertThat(ran.exitCode()).as(ran.err()).isZero();
        assertThat(ran.out()).contains("all 19 states up to symmetry");
        assertThat(Files.readString(dot).lines().filter(line -> line.matches(" +s\\d+ \\[.*")))
                .hasSize(19);
    }

    @Test
    void wrongUsageIsNamed() {
        assertThat(CommandResult.crw("graph", "kanban-1").err()).contains("--svg FILE, --dot FILE or both");
        assertThat(CommandResult.crw("graph", "kanban-1", "--svg", "a", "--states", "3000")
                        .err())
                .contains("--states is 1 to 2000 with --svg, not 3000");
        assertThat(CommandResult.crw("graph", "nothing-such", "--dot", "a").exitCode())
                .isEqualTo(2);
    }

    @Test
    void graphOfAPlanNamesItsPlacesBoatsAndEnds() throws IOException {
        Path dot = folder.resolve("clv.dot");

        CommandResult ran =
                CommandResult.crw("graph", "clv", "--boats", "1", "--states", "500", "--dot", dot.toString());

        assertThat(ran.exitCode()).as(ran.err()).isZero();
        assertThat(ran.out()).contains("Cooperative Location Visit").containsPattern("all \\d+ states");
        assertThat(Files.readString(dot)).contains("1 boat", "robot-1", "Boats chosen", "· end", "peripheries=2");
    }
}
