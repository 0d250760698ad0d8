package org.sami.spn.analysis;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Stream;
import org.sami.spn.finding.Advice;
import org.sami.spn.finding.Finding;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.SubMissionSpec;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * All checks of plans. A plan with an error is not started (thesis 5.1). Pointers are those of the project's document, whose
 * order is the model's.
 */
public final class PlanChecks {
    /** What must be right for the plan to be read, and what says which parts of it never run. */
    private static final List<PlanCheck> OF_PLANS = List.of(
            new KnownNames(),
            new StartPlace(),
            new EndPlaces(),
            new Reachability(),
            new EdgesWithoutRequirement(),
            new TransitionsThatNeverFire(),
            new FieldValues(),
            new KnownVariables(),
            new VariableTypes(),
            new VariableUse(),
            new SubMissionCheck(),
            new NamedTasks(),
            new DisabledForTrying());

    /** What goes wrong in a run. */
    private static final List<PlanCheck> OF_RUNS = List.of(
            new CausesOfInputs(),
            new AnswersOfOutputs(),
            new FailuresOfOutputs(),
            new TokensForOutputs(),
            new RequirementsAndEvents(),
            new RelevantTokenCheck(),
            new MissedAnswers(),
            new RequiredFields(),
            new Contradictions(),
            new Inhibitors(),
            new EmptyPools(),
            new SharedInstancesOver(),
            new MissingSubMissions(),
            new ReturnValues(),
            new CommandsAtTheEnd(),
            new Livelocks(),
            new TaskFields(),
            new InterruptNames(),
            new Autonomy(),
            new PhaseBranches(),
            new FarLocations(),
            new AvoidedAreas(),
            new WaysBeyondRange(),
            new OutOfRange(),
            new UnusualValues(),
            new FractionsForPercent(),
            new FieldOrder(),
            new UnknownWords(),
            new UnknownRobots(),
            new EmptyQuestions(),
            new AppliesNothing(),
            new ReadsBeforeWrites(),
            new FixedNumbers(),
            new TooManyRequired(),
            new EndsWithFirst(),
            new ForgottenPlaces(),
            new OpenGates(),
            new TwoCommands(),
            new TwoTakers(),
            new HealthyLedAway(),
            new TasksMadeAgain(),
            new EndlessRounds());

    /** Checks whose findings do not follow from other faults of the document. */
    private static final List<PlanCheck> INDEPENDENT = List.of(new StartPlace());

    private PlanChecks() {}

    /** Why each finding about a plan matters and how it is mended: one for each code, in the order of the checks. */
    public static List<Advice> advice() {
        return Stream.of(OF_PLANS, OF_RUNS, List.<PlanCheck>of(new HandledOutputs(Set.of())))
                .flatMap(List::stream)
                .flatMap(check -> check.advice().stream())
                .toList();
    }

    /**
     * The findings about plans whose document has errors, and which are therefore not loaded: only what does not follow
     * from those errors, so that an author learns of everything at once and of nothing twice.
     */
    public static List<Finding> checkUnloaded(Project project, Vocabulary vocabulary) {
        return check(
                project,
                vocabulary,
                project.plans().stream().filter(p -> !p.places().isEmpty()).toList(),
                context -> found(context, INDEPENDENT));
    }

    /** The findings about all plans of a project, in the order of the document. */
    public static List<Finding> check(Project project, Vocabulary vocabulary) {
        return check(project, vocabulary, project.plans(), PlanChecks::check);
    }

    /**
     * The findings that matter to a run of one plan: about it and about all plans that it runs as sub-missions. Empty where
     * the project has no such plan.
     */
    public static List<Finding> check(Project project, Vocabulary vocabulary, String planId) {
        return check(project, vocabulary, withDescendants(project, planId), PlanChecks::check);
    }

    /**
     * Warnings of output events that nothing would handle in a program, in the order of the document.
     *
     * @param handled the output events that the program has handlers for, by name
     */
    public static List<Finding> checkHandled(Project project, Vocabulary vocabulary, Set<String> handled) {
        return check(
                project, vocabulary, project.plans(), context -> found(context, List.of(new HandledOutputs(handled))));
    }

    private static List<Finding> check(
            Project project, Vocabulary vocabulary, List<Plan> plans, Function<PlanContext, List<Finding>> check) {
        ProjectContext context = new ProjectContext(project, vocabulary);
        List<Finding> findings = new ArrayList<>();
        plans.forEach(plan -> findings.addAll(check.apply(context.of(plan))));
        findings.sort(DocumentOrder.BY_POINTER);
        return List.copyOf(findings);
    }

    /** The findings of all checks about one plan, in the order of the checks. */
    static List<Finding> check(PlanContext plan) {
        List<Finding> findings = found(plan, OF_PLANS);
        findings.addAll(new PartsThatNeverRun(plan).without(found(plan, OF_RUNS)));
        return findings;
    }

    private static List<Finding> found(PlanContext plan, List<PlanCheck> checks) {
        List<Finding> findings = new ArrayList<>();
        checks.forEach(check -> check.check(
                plan, finding -> findings.add(finding.inPlan(plan.plan().id()))));
        return findings;
    }

    private static List<Plan> withDescendants(Project project, String planId) {
        Set<Plan> found = new LinkedHashSet<>();
        Deque<String> open = new ArrayDeque<>(List.of(planId));
        while (!open.isEmpty()) {
            project.plan(open.pop()).filter(found::add).ifPresent(plan -> {
                for (Place place : plan.places()) {
                    place.subMissions().stream().map(SubMissionSpec::plan).forEach(open::push);
                }
            });
        }
        return List.copyOf(found);
    }
}
