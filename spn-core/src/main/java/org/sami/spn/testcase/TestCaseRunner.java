package org.sami.spn.testcase;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import org.sami.spn.engine.Engine;
import org.sami.spn.finding.Finding;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.TestCase;
import org.sami.spn.protocol.Effect;
import org.sami.spn.stepping.Stepper;
import org.sami.spn.stepping.TakenStep;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * Runs saved test cases on the engine itself, each on a fresh mission: what is tested is what runs. Nobody but the test case
 * answers, and time stands still unless a step lets it pass.
 */
public final class TestCaseRunner {
    private final Project project;
    private final Engine engine;

    /** A runner of the test cases of one project, whose plans have passed the checks. */
    public TestCaseRunner(Project project, Vocabulary vocabulary) {
        this.project = Objects.requireNonNull(project, "project");
        this.engine = new Engine(vocabulary, project);
    }

    /** Runs all test cases of all plans. Empty where all went as expected. */
    public List<Finding> runAll() {
        List<Finding> findings = new ArrayList<>();
        project.plans()
                .forEach(
                        plan -> plan.testCases().forEach(test -> run(plan, test).ifPresent(findings::add)));
        return List.copyOf(findings);
    }

    /**
     * One run of a test case.
     *
     * @param failure where it went another way; empty where it passed
     * @param entered ids of the plan's places that were entered
     * @param fired ids of the plan's transitions that fired
     */
    public record Trace(Optional<Finding> failure, Set<String> entered, Set<String> fired) {}

    /** Runs one test case up to the first step that went another way; empty where none did. */
    public Optional<Finding> run(Plan plan, TestCase test) {
        return trace(plan, test).failure();
    }

    /** Runs one test case up to the first step that went another way, and says what of its plan was visited until then. */
    public Trace trace(Plan plan, TestCase test) {
        Set<String> entered = new LinkedHashSet<>();
        Set<String> fired = new LinkedHashSet<>();
        if (plan.startPlace().isEmpty()) {
            return new Trace(
                    Optional.of(finding(plan, test, "", "cannot run: the plan has no start place")), entered, fired);
        }
        Stepper stepper;
        try {
            stepper = Stepper.startAs(engine, plan.id(), test);
        } catch (IllegalArgumentException refused) {
            return new Trace(
                    Optional.of(finding(plan, test, "/start", "cannot start: " + refused.getMessage())),
                    entered,
                    fired);
        }
        saw(stepper, stepper.startEffects(), entered, fired);
        for (int i = 0; i < test.steps().size(); i++) {
            TakenStep taken = stepper.take(test.steps().get(i));
            if (taken.refusal().isPresent()) {
                String difference = "step " + (i + 1) + ": " + taken.refusal().get();
                return new Trace(Optional.of(finding(plan, test, "/steps/" + i, difference)), entered, fired);
            }
            saw(stepper, taken.effects(), entered, fired);
        }
        return new Trace(Optional.empty(), entered, fired);
    }

    private static void saw(Stepper stepper, List<Effect> effects, Set<String> entered, Set<String> fired) {
        for (Effect effect : effects) {
            if (effect instanceof Effect.Entered e && e.mission() == stepper.mission()) {
                entered.add(e.place());
            } else if (effect instanceof Effect.Fired e && e.mission() == stepper.mission()) {
                fired.add(e.transition());
            }
        }
    }

    private Finding finding(Plan plan, TestCase test, String where, String what) {
        String pointer = "/plans/" + project.plans().indexOf(plan) + "/testCases/"
                + plan.testCases().indexOf(test) + where;
        return Finding.error("E-TEST-CASE", pointer, "Test case \"" + test.name() + "\", " + what, plan.id());
    }
}
