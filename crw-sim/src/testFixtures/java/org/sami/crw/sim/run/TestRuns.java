package org.sami.crw.sim.run;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import org.sami.crw.decision.AnswersFile;
import org.sami.crw.decision.AnswersFileReader;
import org.sami.crw.report.RunReport;
import org.sami.crw.sim.run.settings.FleetSettings;
import org.sami.crw.sim.run.settings.RunPlan;
import org.sami.crw.sim.run.settings.RunSettings;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.model.Project;

/** Runs for tests: of the library's plans, and of the sample with sub-missions, timers and decisions. */
public final class TestRuns {
    /** The domain that ships. */
    public static final DomainLibrary LIBRARY =
            DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();

    private static final String SAMPLES = "/org/sami/crw/sim/";

    private TestRuns() {}

    /** A plan of the library. */
    public static RunPlan plan(String id) {
        Project project = LIBRARY.projectOf(id).orElseThrow();
        return new RunPlan(LIBRARY.vocabulary(), project, project.plan(id).orElseThrow());
    }

    /** The sample: two legs of visits, rests in a sub-mission, a timer, five kinds of decisions. */
    public static RunPlan sample() {
        Project project = new ProjectReader(LIBRARY.vocabulary())
                .read(text("sample-project.json"))
                .orThrow();
        return new RunPlan(LIBRARY.vocabulary(), project, project.plan("sample").orElseThrow());
    }

    /** What the operator answers in the sample. */
    public static AnswersFile sampleAnswers() {
        return AnswersFileReader.read(text("sample-answers.json"), LIBRARY.vocabulary())
                .orThrow();
    }

    /** Settings of a run of the sample. */
    public static RunSettings sampleSettings() {
        return RunSettings.of("sample", "sample", new FleetSettings(3, 5, 120, 11))
                .limitMillis(3_600_000)
                .answerAfterMillis(4_000)
                .answers(text("sample-answers.json"))
                .build();
    }

    /** Settings with all that most tests leave alone. */
    public static RunSettings settings(RunPlan plan, int boats, int locations, long seed) {
        return RunSettings.of(plan.plan().id(), plan.plan().name(), new FleetSettings(boats, locations, 600, seed))
                .limitMillis(7_200_000)
                .build();
    }

    /** Runs to the end. */
    public static RunReport run(RunPlan plan, RunSettings settings) {
        return new InProcessRun(plan, settings, AnswersFile.EMPTY, RunJournal.none())
                .run(Pacer.UNPACED, RunObserver.NONE);
    }

    /** A resource of the tests as text. */
    public static String text(String name) {
        try (InputStream in = TestRuns.class.getResourceAsStream(SAMPLES + name)) {
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
