package org.sami.crw.cli.legacy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sami.crw.report.RunOutcome;
import org.sami.crw.sim.run.RunObserver;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.legacy.LegacyImport;
import org.sami.spn.legacy.LegacyTableReader;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.vocabulary.Vocabulary;

/** The real plans of the earlier fleet run; skipped where they are absent, since their licence keeps them out of the project. */
@Tag("long")
class RealPlansTest {
    private static final Path FOLDER = Path.of("../../shared/legacy-plans");
    private static final String CRW = "/org/sami/domain/crw";

    /** Goes round several times a second for as long as it may: what it does in minutes it does in an hour. */
    private static final String RESTLESS = "Connect and SK";

    private static final TrialSettings HOUR = TrialSettings.of(3);
    private static final TrialSettings MINUTES = new TrialSettings(
            HOUR.boats(),
            HOUR.locations(),
            HOUR.areaM(),
            HOUR.millis() / 10,
            HOUR.answerAfterMillis(),
            HOUR.pressEveryMillis() / 10,
            HOUR.seed());

    @ParameterizedTest
    @CsvSource({"thesis, 17", "crw, 45"})
    void everyRootPlanRunsAndSaysWhatItWaitsFor(String name, int roots) {
        Path file = FOLDER.resolve(name + ".json");
        assumeTrue(Files.exists(file), "skipped: " + file + " is not here");
        Vocabulary vocabulary = DomainLibrary.fromClassPath(CRW).orThrow().vocabulary();
        LegacyImport.Result imported = new LegacyImport(
                        vocabulary,
                        LegacyTableReader.fromClassPath(CRW + "/legacy.json", vocabulary)
                                .orThrow())
                .read(file);
        Project project = imported.project().orElseThrow();
        assertThat(imported.roots()).hasSize(roots);
        for (String root : imported.roots()) {
            Plan plan = project.plan(root).orElseThrow();
            TrialSettings settings = plan.name().equals(RESTLESS) ? MINUTES : HOUR;
            PlanTrial trial = new PlanTrials(vocabulary, project, settings).run(plan, RunObserver.NONE);

            assertThat(trial.isSound())
                    .as("%s: %s %s", trial.name(), trial.reason(), trial.findings())
                    .isTrue();
            if (trial.name().equals("Explore Area")) {
                assertThat(trial.outcome()).as(trial.name()).isEqualTo(RunOutcome.ENDED);
            }
            assertThat(trial.waitsFor().isEmpty()).as(trial.name()).isEqualTo(trial.outcome() != RunOutcome.RUNNING);
            assertThat(trial.waitsFor()).as(trial.name()).allSatisfy(wait -> {
                assertThat(wait.place()).isNotBlank();
                assertThat(wait.occurrence()).isNotBlank();
            });
        }
    }
}
