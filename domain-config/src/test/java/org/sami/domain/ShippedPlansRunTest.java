package org.sami.domain;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.sami.spn.finding.Finding;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.TestCase;
import org.sami.spn.model.TestStep;
import org.sami.spn.testcase.TestCaseRunner;

/** Every plan that ships runs its own test cases, on the engine, as its author saved them. */
class ShippedPlansRunTest {
    private static final int LEAST_CASES = 7;
    private static final DomainLibrary LIBRARY =
            DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();

    record Saved(Project project, Plan plan, TestCase test) {
        @Override
        public String toString() {
            return plan.id() + ": " + test.name();
        }
    }

    static Stream<Saved> savedCases() {
        return LIBRARY.projects().values().stream()
                .flatMap(project -> project.plans().stream()
                        .flatMap(plan -> plan.testCases().stream().map(test -> new Saved(project, plan, test))));
    }

    @ParameterizedTest
    @MethodSource("savedCases")
    void goesAsItsAuthorExpected(Saved saved) {
        TestCaseRunner runner = new TestCaseRunner(saved.project(), LIBRARY.vocabulary());

        assertThat(runner.run(saved.plan(), saved.test())).isEmpty();
    }

    @Test
    void everyPlanHasCases() {
        assertThat(savedCases()).hasSizeGreaterThanOrEqualTo(LEAST_CASES);
        assertThat(LIBRARY.plans()).allMatch(plan -> !plan.testCases().isEmpty());
    }

    @Test
    void caseThatGoesAnotherWayIsNamedWithItsStep() {
        Project project = LIBRARY.projectOf("clv").orElseThrow();
        Plan plan = project.plan("clv").orElseThrow();
        TestCase good = plan.testCases().get(0);
        TestCaseRunner runner = new TestCaseRunner(project, LIBRARY.vocabulary());

        List<String> messages = Stream.of(
                        new TestStep.ExpectTokens("execute", 2, List.of("b1"), List.of()),
                        new TestStep.ExpectEnded(),
                        new TestStep.Answer("ask-boats", new TestStep.Reply.YesNo(true)),
                        new TestStep.Occur("AllocationResponse", "ask-allocation", List.of("b1"), List.of(), Map.of()))
                .map(wrong -> {
                    List<TestStep> changed = new ArrayList<>(good.steps().subList(0, 4));
                    changed.add(wrong);
                    return runner.run(plan, new TestCase("changed", good.proxies(), changed));
                })
                .map(finding -> finding.map(Finding::message).orElse("nothing found"))
                .toList();

        assertThat(messages)
                .allMatch(m -> m.startsWith("Test case \"changed\", step 5: "))
                .anyMatch(m ->
                        m.endsWith("expected in Execute paths are generic, generic, b1, found b1, b2, b3, generic"));
    }
}
