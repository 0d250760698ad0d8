package org.sami.crw.sim.experiment;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.OptionalLong;
import java.util.concurrent.atomic.AtomicBoolean;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.sami.crw.decision.AnswersFile;
import org.sami.crw.report.RunOutcome;
import org.sami.crw.report.RunReport;
import org.sami.crw.sim.hull.Conditions;
import org.sami.crw.sim.run.TestRuns;
import org.sami.crw.sim.run.settings.FleetSettings;
import org.sami.crw.sim.run.settings.RunSettings;

/** Many runs side by side come out as they do one by one. */
@Tag("long")
class ExperimentTest {
    private static final List<ExperimentCase> CASES =
            List.of(of("clv", 200), of("measure", 150), of("explore-area", 150));
    private static final Map<String, Conditions> WATERS = waters();
    private static final List<Long> SEEDS = List.of(4L, 2L);
    private static final Experiment EXPERIMENT = new Experiment(CASES, WATERS, SEEDS);

    @Test
    void rowsAreTheSameOnAnyNumberOfThreads() {
        List<Integer> progress = new ArrayList<>();

        List<ExperimentRow> alone = EXPERIMENT.run(1, () -> false, progress::add);
        List<ExperimentRow> sideBySide = EXPERIMENT.run(5, () -> false, done -> {});

        assertThat(sideBySide).isEqualTo(alone);
        assertThat(ExperimentTable.text(sideBySide)).isEqualTo(ExperimentTable.text(alone));
        assertThat(progress).containsExactly(1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12);
        assertThat(alone)
                .extracting(row -> row.run().label() + " " + row.run().conditions() + " "
                        + row.run().seed())
                .startsWith("clv calm 4", "clv calm 2", "clv field 4", "clv field 2", "measure calm 4")
                .hasSize(12)
                .doesNotHaveDuplicates();
        assertThat(alone).allMatch(ExperimentRow::isGreen);
        assertThat(alone)
                .filteredOn(row -> row.run().conditions().equals("field"))
                .extracting(row -> row.ending().hash())
                .doesNotHaveDuplicates();
    }

    @Test
    void rowSaysWhatTheReportOfTheRunAloneSays() {
        ExperimentCase clv = CASES.get(0);
        RunReport report = TestRuns.run(
                clv.plan(),
                clv.settings()
                        .withFleet(clv.settings().fleet().on(Conditions.FIELD).drawnFrom(2)));

        ExperimentRow row = new Experiment(List.of(clv), Map.of("field", Conditions.FIELD), List.of(2L))
                .run(2, () -> false, done -> {})
                .get(0);

        assertThat(row.ending().hash()).isEqualTo(report.result().runHash());
        assertThat(row.ending().simulatedMillis()).isEqualTo(report.result().simulatedMillis());
        assertThat(row.visits().reported())
                .isEqualTo(report.locationsReported())
                .isEqualTo(9);
        assertThat(row.visits().visited()).isEqualTo(report.locationsVisited());
        assertThat(row.distances().closestM().orElseThrow())
                .isEqualTo(report.map().closest().ever().orElseThrow().distanceM());
    }

    /** A run that takes long, also where the one who stops it is late. */
    private static ExperimentCase exploring() {
        return new ExperimentCase(
                "explore",
                CASES.get(2).plan(),
                CASES.get(2).settings().withFleet(new FleetSettings(200, 9, 1300, 1)),
                AnswersFile.EMPTY);
    }

    @Test
    void runsThatAreStoppedAreLeftOut() {
        AtomicBoolean stop = new AtomicBoolean();
        Experiment experiment = new Experiment(
                List.of(CASES.get(0), exploring()), Map.of("calm", Conditions.CALM), List.of(1L, 2L, 3L));

        List<ExperimentRow> rows = experiment.run(1, stop::get, done -> stop.set(done >= 3));

        assertThat(rows).extracting(row -> row.run().label()).containsExactly("clv", "clv", "clv");
        assertThat(rows).extracting(row -> row.ending().outcome()).containsOnly(RunOutcome.ENDED);
    }

    @Test
    void runsThatAreLongUnderWayAreNotWaitedForWhenItStops() {
        Thread caller = Thread.currentThread();
        AtomicBoolean first = new AtomicBoolean();
        AtomicBoolean over = new AtomicBoolean();
        Experiment experiment =
                new Experiment(List.of(CASES.get(0), exploring()), Map.of("calm", Conditions.CALM), List.of(1L));

        List<ExperimentRow> rows;
        try {
            rows = experiment.run(
                    1,
                    () -> over.get() || (first.get() && Thread.currentThread() == caller), // runs do not heed it
                    done -> first.set(true));
        } finally {
            over.set(true);
        }

        assertThat(rows).extracting(row -> row.run().label()).containsExactly("clv");
    }

    @Test
    void tableNamesEachRunThatDidNotEnd() {
        ExperimentCase tooShort = new ExperimentCase(
                "clv",
                CASES.get(0).plan(),
                CASES.get(0).settings().withLimit(OptionalLong.of(30_000)),
                AnswersFile.EMPTY);

        String table = ExperimentTable.text(new Experiment(List.of(tooShort), Map.of("calm", Conditions.CALM), SEEDS)
                .run(2, () -> false, done -> {}));

        assertThat(table.lines().toList()).hasSize(4).element(1).asString().startsWith("clv   calm           2      0");
        assertThat(table)
                .contains("clv, calm, seed 4: running after 30 s\n", "clv, calm, seed 2: running after 30 s\n");
    }

    @Test
    void tableNamesEachRunInWhichABoatCameDeeperThanWasAnnounced() {
        List<ExperimentRow> rows = List.of(inside(1, 8.34, 8.3), inside(2, 8.36, 8.3), inside(3, 0, 0));

        assertThat(rows).extracting(ExperimentRow::isGreen).containsExactly(true, false, true);
        assertThat(ExperimentTable.text(rows).lines().skip(2))
                .containsExactly("rocks, rough, seed 2: ended after 1 min 0 s; a boat came deeper into avoided areas "
                        + "than announced: 8.4 m, not 8.3 m at most");
    }

    @Test
    void tableCountsTargetsOfRunsWhoseDetectorsReportedSome() {
        List<ExperimentRow> searched = List.of(row("search", 3), row("search", 2), row("clv", 0));

        assertThat(ExperimentTable.text(searched).lines())
                .satisfiesExactly(
                        head -> assertThat(head).endsWith("empty  targets"),
                        search -> assertThat(search).endsWith("0        5"),
                        clv -> assertThat(clv).endsWith("0        0"));
        assertThat(ExperimentTable.text(List.of(row("clv", 0)))).doesNotContain("targets");
        assertThat(ExperimentTable.csv(searched).lines().skip(1))
                .extracting(line -> line.split(",", -1)[20])
                .containsExactly("3", "2", "0");
        assertThat(ExperimentRowText.read(ExperimentRowText.write(searched.get(0))))
                .isEqualTo(searched.get(0));
    }

    private static ExperimentRow row(String plan, int targets) {
        OptionalDouble none = OptionalDouble.empty();
        return new ExperimentRow(
                new ExperimentRow.Run(plan, "calm", 1),
                new ExperimentRow.Ending(RunOutcome.ENDED, "", 0, 60_000, ""),
                new ExperimentRow.Visits(0, 0, 0, none),
                new ExperimentRow.Coverage(0, none, 0),
                new ExperimentRow.Distances(none, none, none, none, 0),
                0,
                targets);
    }

    private static ExperimentRow inside(long seed, double insideM, double announcedM) {
        OptionalDouble none = OptionalDouble.empty();
        return new ExperimentRow(
                new ExperimentRow.Run("rocks", "rough", seed),
                new ExperimentRow.Ending(RunOutcome.ENDED, "", 0, 60_000, ""),
                new ExperimentRow.Visits(0, 0, 0, none),
                new ExperimentRow.Coverage(0, none, 0),
                new ExperimentRow.Distances(OptionalDouble.of(insideM), OptionalDouble.of(announcedM), none, none, 0),
                0,
                0);
    }

    private static Map<String, Conditions> waters() {
        Map<String, Conditions> waters = new LinkedHashMap<>();
        waters.put("calm", Conditions.CALM);
        waters.put("field", Conditions.FIELD);
        return waters;
    }

    private static ExperimentCase of(String plan, double areaM) {
        RunSettings settings = RunSettings.of(plan, plan, new FleetSettings(3, 9, areaM, 1))
                .limitMillis(7_200_000)
                .build();
        return new ExperimentCase(plan, TestRuns.plan(plan), settings, AnswersFile.EMPTY);
    }
}
