package org.sami.crw.gui.robot;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** docs/robot-run.md lists what the robot does, in its order. */
class RobotRunPageTest {
    private static final Path PAGE = Path.of("..", "docs", "robot-run.md");

    private static final List<RobotRow> MISTAKES = Stream.of(
                    AnswerMistakes.ROWS, MissionMistakes.ROWS, FleetMistakes.ROWS, PanelMistakes.ROWS)
            .flatMap(List::stream)
            .toList();
    private static final List<RobotRow> ATTACKS = Stream.of(LinkAttacks.ROWS, FileAttacks.ROWS, DiskAttacks.ROWS)
            .flatMap(List::stream)
            .toList();

    private static List<String> lines(List<RobotRow> rows) {
        List<String> lines = new ArrayList<>();
        for (RobotRow row : rows) {
            lines.add("| " + (lines.size() + 1) + " | " + row.name().replace("<", "&lt;") + " | " + row.holds() + " |");
        }
        return lines;
    }

    @Test
    void thePageListsTheRowsAndWhatMustHold() throws IOException {
        List<String> tables = Files.readAllLines(PAGE).stream()
                .filter(line -> line.matches("\\| \\d+ \\|.*"))
                .toList();
        List<String> all = new ArrayList<>(lines(MISTAKES));
        all.addAll(lines(ATTACKS));

        assertThat(tables).containsExactlyElementsOf(all);
    }

    @Test
    void thereAreFortyMistakesAndThirtyAttacksAndNoTwoOfOneName() {
        assertThat(MISTAKES).hasSize(40);
        assertThat(ATTACKS).hasSize(30);
        assertThat(Stream.concat(MISTAKES.stream(), ATTACKS.stream()).map(RobotRow::name))
                .doesNotHaveDuplicates();
    }
}
