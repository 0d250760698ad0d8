package org.sami.uav.handler;

import java.util.List;
import java.util.Map;
import org.sami.crw.decision.AnswersFile;
import org.sami.crw.decision.AnswersFileReader;
import org.sami.crw.fleet.RobotKind;
import org.sami.crw.report.RunReport;
import org.sami.crw.sim.hull.NamedConditions;
import org.sami.crw.sim.run.InProcessRun;
import org.sami.crw.sim.run.Pacer;
import org.sami.crw.sim.run.RunJournal;
import org.sami.crw.sim.run.RunObserver;
import org.sami.crw.sim.run.settings.FleetSettings;
import org.sami.crw.sim.run.settings.InitialCharges;
import org.sami.crw.sim.run.settings.RunPlan;
import org.sami.crw.sim.run.settings.RunSettings;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.model.Project;

/** Runs of the shipped plans on simulated copters. */
final class UavRuns {
    static final DomainLibrary DOMAIN =
            DomainLibrary.fromClassPath("/org/sami/domain/uav").orThrow();

    private static final double AREA_M = 400; // large enough for targets

    private UavRuns() {}

    /** One run, with what differs from the usual. */
    record Run(
            String plan,
            int copters,
            NamedConditions weather,
            String charges,
            Map<String, String> values,
            List<String> also,
            String answers) {
        static Run of(String plan, int copters) {
            return new Run(plan, copters, NamedConditions.CALM, "100", Map.of(), List.of(), "");
        }

        Run with(Map<String, String> others) {
            return new Run(plan, copters, weather, charges, others, also, answers);
        }

        Run in(NamedConditions other) {
            return new Run(plan, copters, other, charges, values, also, answers);
        }

        Run charged(String percent) {
            return new Run(plan, copters, weather, percent, values, also, answers);
        }

        Run also(String... missions) {
            return new Run(plan, copters, weather, charges, values, List.of(missions), answers);
        }

        Run answering(String rules) {
            return new Run(plan, copters, weather, charges, values, also, rules);
        }

        InProcessRun prepared() {
            return prepared(DOMAIN.combined());
        }

        /** Of a project of the test's own. */
        InProcessRun prepared(Project project) {
            String text = "{\"format\": \"crw-answers\", \"version\": 1, \"rules\": [" + answers + "]}";
            FleetSettings fleet = new FleetSettings(copters, 4, AREA_M, 3)
                    .of(RobotKind.COPTER)
                    .on(weather.conditions())
                    .with(InitialCharges.parse(charges));
            RunSettings settings = RunSettings.of(plan, plan, fleet)
                    .limitMillis(7_200_000)
                    .parameters(values)
                    .answers(text)
                    .also(also)
                    .build();
            RunPlan runPlan =
                    new RunPlan(DOMAIN.vocabulary(), project, project.plan(plan).orElseThrow());
            AnswersFile file = AnswersFileReader.read(text, DOMAIN.vocabulary()).orThrow();
            return new InProcessRun(runPlan, settings, file, RunJournal.none());
        }

        RunReport report() {
            return prepared().run(Pacer.UNPACED, RunObserver.NONE);
        }

        @Override
        public String toString() {
            return plan;
        }
    }
}
