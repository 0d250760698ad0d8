package org.sami.crw.cli.legacy;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.sami.crw.handler.HandledEvents;
import org.sami.crw.operator.mission.BlockedPlaces;
import org.sami.crw.operator.mission.Wait;
import org.sami.crw.report.RunOutcome;
import org.sami.crw.report.RunReport;
import org.sami.crw.sim.run.InProcessRun;
import org.sami.crw.sim.run.Pacer;
import org.sami.crw.sim.run.RunJournal;
import org.sami.crw.sim.run.RunObserver;
import org.sami.crw.sim.run.settings.FleetSettings;
import org.sami.crw.sim.run.settings.PlanInterrupts;
import org.sami.crw.sim.run.settings.PlanLocations;
import org.sami.crw.sim.run.settings.RunPlan;
import org.sami.crw.sim.run.settings.RunSettings;
import org.sami.crw.sim.run.settings.Site;
import org.sami.spn.analysis.PlanChecks;
import org.sami.spn.finding.Finding;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * Runs plans of a project one after the other, each in a world of its own: simulated boats, the simulated operator, and interrupts
 * pressed at random. A function of the project and its settings, also for each plan alone.
 */
public final class PlanTrials {
    /** An address that no network has (RFC 5737), for plans that ask for one. */
    private static final String SOME_SERVER = "192.0.2.1:11411";

    private static final String SOME_BOAT = "boat at hand";

    private final Vocabulary vocabulary;
    private final Project project;
    private final TrialSettings settings;
    private final Set<String> handled;
    private final List<Finding> checks;

    /** Trials of plans of one project. */
    public PlanTrials(Vocabulary vocabulary, Project project, TrialSettings settings) {
        this.vocabulary = vocabulary;
        this.project = project;
        this.settings = settings;
        handled = HandledEvents.of(vocabulary);
        checks = PlanChecks.check(project, vocabulary);
    }

    /** Runs a plan, unless the observer wants an end. */
    public PlanTrial run(Plan plan, RunObserver observer) {
        long seed = settings.seed() * 31 + project.plans().indexOf(plan);
        FleetSettings fleet = new FleetSettings(settings.boats(), settings.locations(), settings.areaM(), seed)
                .at(Site.at(new PlanLocations(project, plan, List.of()).suitable(Site.USUAL_CENTRE, settings.areaM())));
        List<String> presses =
                RandomInterrupts.draw(new PlanInterrupts(vocabulary, project, plan), fleet.boatNames(), settings, seed);
        RunSettings run = RunSettings.of(plan.id(), plan.title(), fleet)
                .limitMillis(settings.millis())
                .answerAfterMillis(settings.answerAfterMillis())
                .interrupts(presses)
                .build();
        InProcessRun trial = new InProcessRun(
                new RunPlan(vocabulary, project, plan),
                run,
                TrialAnswers.of(SOME_BOAT, SOME_SERVER, project, vocabulary),
                RunJournal.none());
        TrialMonitor watch = new TrialMonitor(vocabulary, project, handled);
        trial.goOnWhenStuck();
        trial.addListener(watch);
        RunReport report = trial.run(Pacer.UNPACED, observer);
        return result(plan, trial, watch, report);
    }

    private PlanTrial result(Plan plan, InProcessRun trial, TrialMonitor watch, RunReport report) {
        trial.ask(view -> {
            watch.lookForCopies(view);
            return true;
        });
        trial.operatorTroubles().forEach(trouble -> watch.unanswered(plan.id(), trouble));
        List<Finding> findings = new ArrayList<>(checksOf(watch.plansThatRan()));
        findings.addAll(watch.findings());
        List<Wait> waits = report.result().outcome() == RunOutcome.RUNNING
                ? trial.ask(view -> BlockedPlaces.of(vocabulary, view))
                : List.of();
        return new PlanTrial(
                plan.id(),
                plan.title(),
                report.result().outcome(),
                report.result().reason(),
                report.result().simulatedMillis(),
                report.firings().size(),
                report.decisions().size(),
                (int) report.notes().stream()
                        .filter(note -> note.kind().endsWith(" message"))
                        .count(),
                waits,
                findings);
    }

    private List<Finding> checksOf(Set<String> plans) {
        List<Finding> found = new ArrayList<>();
        for (int i = 0; i < project.plans().size(); i++) {
            String at = "/plans/" + i;
            if (plans.contains(project.plans().get(i).id())) {
                checks.stream()
                        .filter(f -> f.pointer().equals(at) || f.pointer().startsWith(at + "/"))
                        .forEach(found::add);
            }
        }
        return found;
    }

    /** Name of the simulated boat that stands for each server that the project names, and for the one that the operator gives. */
    public Map<String, String> boatOfServer() {
        Map<String, String> all = Servers.of(project);
        all.putIfAbsent(SOME_SERVER, SOME_BOAT);
        return all;
    }
}
