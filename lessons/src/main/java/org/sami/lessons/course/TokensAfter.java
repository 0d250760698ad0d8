package org.sami.lessons.course;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import org.sami.spn.engine.Engine;
import org.sami.spn.engine.MissionView;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.TestCase;
import org.sami.spn.model.TestStep;
import org.sami.spn.protocol.Token;
import org.sami.spn.stepping.Stepper;
import org.sami.spn.stepping.TakenStep;
import org.sami.spn.vocabulary.Vocabulary;

/** Where tokens stand after the first steps of a test case: the engine says it. */
public final class TokensAfter {
    private TokensAfter() {}

    /**
     * The places with tokens, in the plan's order.
     *
     * @param testCase the name of a test case of the plan
     * @param steps how many of its steps are taken
     * @throws IllegalArgumentException if there is no such test case, or it goes another way
     */
    public static List<TokensAt> of(Project project, Vocabulary vocabulary, Plan plan, String testCase, int steps) {
        TestCase test = plan.testCases().stream()
                .filter(each -> each.name().equals(testCase))
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException(
                        "the plan \"" + plan.id() + "\" has no test case \"" + testCase + "\""));
        if (steps < 0 || steps > test.steps().size()) {
            throw new IllegalArgumentException(
                    "the test case \"" + testCase + "\" has " + test.steps().size() + " steps, not " + steps);
        }
        Stepper stepper = Stepper.startAs(new Engine(vocabulary, project), plan.id(), test);
        for (TestStep step : test.steps().subList(0, steps)) {
            TakenStep taken = stepper.take(step);
            taken.refusal().ifPresent(why -> {
                throw new IllegalArgumentException("the test case \"" + testCase + "\" goes another way: " + why);
            });
        }
        Map<String, List<Token>> marking = stepper.view()
                .mission(stepper.mission())
                .map(MissionView::marking)
                .orElse(Map.of());
        return plan.places().stream()
                .map(place -> at(place.id(), marking.getOrDefault(place.id(), List.of())))
                .filter(at -> !at.isEmpty())
                .toList();
    }

    private static TokensAt at(String place, List<Token> tokens) {
        List<String> robots = new ArrayList<>();
        List<String> tasks = new ArrayList<>();
        for (Token token : tokens) {
            if (token instanceof Token.Proxy robot) {
                robots.add(robot.proxy());
            } else if (token instanceof Token.Task task) {
                tasks.add(task.task().name());
            }
        }
        return new TokensAt(place, Collections.frequency(tokens, Token.GENERIC), robots, tasks);
    }
}
