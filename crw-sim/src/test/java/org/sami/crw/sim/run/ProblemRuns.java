package org.sami.crw.sim.run;

import java.util.Map;
import org.sami.crw.decision.AnswersFile;
import org.sami.crw.decision.AnswersFileReader;
import org.sami.crw.report.RunReport;
import org.sami.crw.sim.run.settings.FleetSettings;
import org.sami.crw.sim.run.settings.InitialCharges;
import org.sami.crw.sim.run.settings.RunPlan;
import org.sami.crw.sim.run.settings.RunSettings;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.model.Project;

/** Runs of the plans of {@code problem-project.json}, on one boat. */
final class ProblemRuns {
    private static final int BOATS = 1;

    private ProblemRuns() {}

    static RunReport run(String id, Map<String, String> parameters, InitialCharges charges, String rules) {
        return of(id, parameters, charges, rules).run(Pacer.UNPACED, RunObserver.NONE);
    }

    static InProcessRun of(String id, Map<String, String> parameters, InitialCharges charges, String rules) {
        return of(TestRuns.text("problem-project.json"), id, parameters, charges, rules);
    }

    /** A run on one boat that the project keeps out of an area. */
    static RunReport runWithNoGo(String area, String id, Map<String, String> parameters) {
        String project = TestRuns.text("problem-project.json")
                .replaceFirst(
                        "\"domain\":",
                        "\"globals\": [{\"name\": \"@noGo\", \"type\": \"list<area>\", \"initial\": [" + area
                                + "]}],\n  \"domain\":");
        return of(project, id, parameters, InitialCharges.FULL, "").run(Pacer.UNPACED, RunObserver.NONE);
    }

    private static InProcessRun of(
            String text, String id, Map<String, String> parameters, InitialCharges charges, String rules) {
        Project project =
                new ProjectReader(TestRuns.LIBRARY.vocabulary()).read(text).orThrow();
        RunPlan plan = new RunPlan(
                TestRuns.LIBRARY.vocabulary(), project, project.plan(id).orElseThrow());
        RunSettings settings = RunSettings.of(id, id, new FleetSettings(BOATS, 1, 600, 1).with(charges))
                .limitMillis(400_000)
                .parameters(parameters)
                .build();
        AnswersFile answers = AnswersFileReader.read(
                        "{\"format\": \"crw-answers\", \"version\": 1, \"rules\": [" + rules + "]}",
                        TestRuns.LIBRARY.vocabulary())
                .orThrow();
        return new InProcessRun(plan, settings, answers, RunJournal.none());
    }
}
