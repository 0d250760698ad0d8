package org.sami.crw.gui.gantt;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.OptionalLong;
import org.junit.jupiter.api.Test;
import org.sami.crw.gui.SessionWorld;
import org.sami.crw.operator.gantt.GanttAction;
import org.sami.crw.operator.gantt.GanttBar;
import org.sami.crw.operator.gantt.GanttMission;
import org.sami.crw.operator.gantt.GanttPhase;
import org.sami.crw.operator.gantt.GanttRow;
import org.sami.spn.phase.PhaseAction;
import org.sami.spn.phase.PhaseChart;
import org.sami.spn.phase.PhaseProgress.Status;

class GanttLinesTest {
    private static final PhaseChart CHART = PhaseChart.of(
            SessionWorld.library("measure").plan("measure").orElseThrow(), SessionWorld.LIBRARY.vocabulary());

    private final GanttLines lines = new GanttLines();

    private static GanttMission mission(long id, String title, long from, OptionalLong until) {
        GanttBar bar = new GanttBar("Sail", from, false, until);
        GanttAction action = new GanttAction(
                new PhaseAction("e", "p", "Sail", "OPERATOR", "Choose", false), Status.DONE, 2, List.of(bar));
        return new GanttMission(
                id,
                title,
                from,
                until,
                List.of(new GanttPhase(
                        "Sail", until.isEmpty() ? Status.ACTIVE : Status.DONE, List.of(bar), List.of(action))),
                List.of(new GanttRow("anna", List.of(bar))),
                CHART,
                Map.of());
    }

    private List<String> labels() {
        return lines.lines().stream().map(GanttLine::label).toList();
    }

    @Test
    void missionsThatRunStandAboveThoseThatHaveEndedAndAreOpen() {
        lines.show(List.of(
                mission(1, "over", 0, OptionalLong.of(9_000)),
                mission(2, "first", 1_000, OptionalLong.empty()),
                mission(3, "second", 2_000, OptionalLong.empty())));

        assertThat(labels()).containsExactly("second", "Sail", "anna", "first", "Sail", "anna", "over");
    }

    @Test
    void aPhaseIsOpenedToItsActionsAndStaysOpenWhenSomethingHappens() {
        lines.show(List.of(mission(1, "one", 0, OptionalLong.empty())));
        lines.toggle(lines.lines().get(1));

        lines.show(List.of(mission(1, "one", 0, OptionalLong.of(5_000))));
        lines.toggle(lines.lines().get(0)); // it has ended and is closed by itself

        assertThat(labels()).containsExactly("one", "Sail", "OPERATOR: Choose", "anna");
        assertThat(lines.lines().get(1).note()).isEqualTo("1 of 1");
        assertThat(lines.lines().get(2).note()).isEqualTo("2 times");
    }

    @Test
    void theTimeBeginsWithTheEarliestMissionThatRunsAndElseWithTheEarliestOfAll() {
        lines.show(List.of(
                mission(1, "over", 0, OptionalLong.of(9_000)), mission(2, "runs", 7_000, OptionalLong.empty())));
        assertThat(lines.start()).hasValue(7_000);
        assertThat(lines.end()).isEmpty();

        lines.show(List.of(
                mission(1, "over", 0, OptionalLong.of(9_000)), mission(2, "too", 7_000, OptionalLong.of(8_000))));
        assertThat(lines.start()).hasValue(0);
        assertThat(lines.end()).hasValue(9_000);
    }

    @Test
    void theAxisHasNowInSightAndRoundMomentsThatAreApart() {
        GanttSpan span = new GanttSpan();
        GanttAxis all = span.axis(OptionalLong.of(15_000), OptionalLong.empty(), 135_000, 1000);
        assertThat(all.x(15_000)).isZero();
        assertThat(all.x(135_000)).isBetween(900.0, 960.0);
        assertThat(all.millis(all.x(60_000))).isEqualTo(60_000);
        assertThat(all.ticks(100)).startsWith(15_000L, 30_000L, 45_000L);

        span.zoom(true);
        assertThat(span.words()).isEqualTo("the last 240 min");
        for (int i = 0; i < 20; i++) {
            span.zoom(true);
        }
        assertThat(span.axis(OptionalLong.of(0), OptionalLong.empty(), 600_000, 1000)
                        .fromMillis())
                .isEqualTo(480_000);
        span.all();
        assertThat(span.words()).isEqualTo("all of it");
    }

    @Test
    void aBarSaysFromWhenToWhen() {
        assertThat(GanttView.words(new GanttBar("Work", 5_000, false, OptionalLong.of(70_000)), 99_000))
                .isEqualTo("Work · 0:00:05 to 0:01:10 · 1 min 5 s");
        assertThat(GanttView.words(new GanttBar("Work", 5_000, true, OptionalLong.empty()), 9_000))
                .isEqualTo("Work · since before 0:00:05 until now · 4 s");
    }
}
