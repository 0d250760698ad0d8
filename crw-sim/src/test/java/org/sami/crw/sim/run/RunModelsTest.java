package org.sami.crw.sim.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.LinkedHashSet;
import java.util.Set;
import java.util.function.Predicate;
import org.junit.jupiter.api.Test;
import org.sami.crw.decision.AnswersFile;
import org.sami.crw.operator.OperatorModels;
import org.sami.crw.operator.boat.BoatCommands.End;
import org.sami.crw.report.DecisionResult;
import org.sami.crw.report.RunReport;
import org.sami.crw.sim.run.settings.RunPlan;

/** The operator's models of a run in process show what they would show over TCP. */
class RunModelsTest {
    private static final int BOATS = 3;

    private final RunPlan plan = TestRuns.plan("clv-interrupts");
    private final InProcessRun run =
            new InProcessRun(plan, TestRuns.settings(plan, BOATS, 6, 5), AnswersFile.EMPTY, RunJournal.none());
    private final OperatorModels models = run.models();

    private RunReport run(RunObserver observer) {
        return run.run(Pacer.UNPACED, observer);
    }

    @Test
    void boatsTheirCommandsAndTheirMissionAreShown() {
        run(RunObserver.NONE);

        assertThat(models.fleet().snapshot())
                .hasSize(BOATS)
                .allMatch(boat -> boat.pose().isPresent())
                .allMatch(boat -> boat.battery().orElseThrow().percent() < 100);
        assertThat(models.commands().snapshot())
                .hasSize(BOATS)
                .allMatch(boat -> boat.concluded().stream().anyMatch(done -> done.end() == End.COMPLETED));
        assertThat(models.missions().snapshot().missions())
                .anyMatch(mission -> mission.hasEnded() && mission.plan().equals("clv-interrupts"));
    }

    @Test
    void buttonsAndWhatBlocksTheMissionAreShownWhileItRuns() {
        Set<String> buttons = new LinkedHashSet<>();
        Set<String> blocked = new LinkedHashSet<>();

        run(new RunObserver(
                progress -> {
                    models.interrupts().snapshot().forEach(button -> buttons.add(button.name()));
                    models.missions()
                            .snapshot()
                            .missions()
                            .forEach(mission -> mission.details().blocked().forEach(wait -> blocked.add(wait.place())));
                },
                () -> false));

        assertThat(buttons).contains("recharge", "alarm");
        assertThat(blocked).isNotEmpty().noneMatch(String::isBlank);
    }

    @Test
    void reportHasTheClicksAndFiringsOfTheModels() {
        RunReport report = run(RunObserver.NONE);

        assertThat(report.result().clicks()).isEqualTo((int) models.clicks().clicks());
        assertThat(report.result().firings())
                .isEqualTo(models.missions().snapshot().firings());
        assertThat(report.decisions().stream().mapToInt(DecisionResult::clicks).sum())
                .as("the others are those of the start")
                .isEqualTo(report.result().clicks() - 1);
    }

    @Test
    void decisionsAreAnsweredAsTheModelsShowThem() {
        Set<Long> shown = new LinkedHashSet<>();
        models.decisions()
                .addListener(pending ->
                        pending.forEach(one -> shown.add(one.decision().id())));

        RunReport report = run(RunObserver.NONE);

        assertThat(report.decisions())
                .isNotEmpty()
                .extracting(DecisionResult::id)
                .allMatch(isIn(shown));
        assertThat(models.decisions().pending()).isEmpty();
    }

    private static Predicate<Long> isIn(Set<Long> shown) {
        return shown::contains;
    }
}
