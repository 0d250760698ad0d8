package org.sami.spn.testcase;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.sami.spn.engine.Engine;
import org.sami.spn.finding.Finding;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.TestCase;
import org.sami.spn.stepping.Stepper;
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

    /** Runs one test case up to the first step that went another way; empty where none did. */
    public Optional<Finding> run(Plan plan, TestCase test) {
        if (plan.startPlace().isEmpty()) {
            return Optional.of(finding(plan, test, "", "cannot run: the plan has no start place"));
        }
        Stepper stepper;
        try {
            stepper = Stepper.startAs(engine, plan.id(), test);
        } catch (IllegalArgumentException refused) {
            return Optional.of(finding(plan, test, "/start", "cannot start: " + refused.getMessage()));
        }
        for (int i = 0; i < test.steps().size(); i++) {
            Optional<String> difference = stepper.take(test.steps().get(i)).refusal();
            if (difference.isPresent()) {
                return Optional.of(finding(plan, test, "/steps/" + i, "step " + (i + 1) + ": " + difference.get()));
            }
        }
        return Optional.empty();
    }

    private Finding finding(Plan plan, TestCase test, String where, String what) {
        String pointer = "/plans/" + project.plans().indexOf(plan) + "/testCases/"
                + plan.testCases().indexOf(test) + where;
        return Finding.error("E-TEST-CASE", pointer, "Test case \"" + test.name() + "\", " + what, plan.id());
    }
}
