package org.sami.spn.edit;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.StartMarking;
import org.sami.spn.model.TestCase;
import org.sami.spn.model.TestStart;
import org.sami.spn.model.TestStep;
import org.sami.spn.model.Transition;
import org.sami.spn.value.Value;
import org.sami.spn.vocabulary.Vocabulary;

/** Removes from an edited plan all references to removed vertices and events, and reports them. */
final class Leftovers {
    private final Plan plan;
    private final Consumer<String> tell;
    private final TestStepCheck steps;
    private final Set<String> places = new HashSet<>();
    private final Set<String> transitions = new HashSet<>();

    Leftovers(Plan plan, Project project, Vocabulary vocabulary, Consumer<String> tell) {
        this.plan = plan;
        this.tell = tell;
        this.steps = new TestStepCheck(plan, project.globals(), vocabulary);
        plan.places().stream().map(Place::id).forEach(places::add);
        plan.transitions().stream().map(Transition::id).forEach(transitions::add);
    }

    Plan removed() {
        Map<String, LayoutPoint> layout = new LinkedHashMap<>(plan.layout());
        layout.keySet().removeIf(id -> !places.contains(id) && !transitions.contains(id));
        return plan.withInEdges(kept(
                        plan.inEdges(),
                        plan.inEdges().stream()
                                .filter(e -> joins(e.id(), e.place(), e.transition()))
                                .toList()))
                .withOutEdges(kept(
                        plan.outEdges(),
                        plan.outEdges().stream()
                                .filter(e -> joins(e.id(), e.place(), e.transition()))
                                .toList()))
                .withLayout(layout)
                .withPlaces(kept(
                        plan.places(), plan.places().stream().map(this::ordered).toList()))
                .withTestCases(kept(
                        plan.testCases(),
                        plan.testCases().stream()
                                .map(this::meaningful)
                                .flatMap(Optional::stream)
                                .toList()));
    }

    /** The list as it was where nothing in it changed: who asks what an edit changed compares lists by identity. */
    private static <T> List<T> kept(List<T> was, List<T> is) {
        return was.equals(is) ? was : is;
    }

    private boolean joins(String edge, String place, String transition) {
        boolean joins = places.contains(place) && transitions.contains(transition);
        if (!joins) {
            tell.accept("The edge " + edge + " of the plan \"" + plan.id() + "\" went along: it joined " + place
                    + " and " + transition);
        }
        return joins;
    }

    private Place ordered(Place place) {
        List<String> order =
                place.transitionOrder().stream().filter(transitions::contains).toList();
        return order.size() == place.transitionOrder().size() ? place : place.withTransitionOrder(order);
    }

    /** The test case without what means nothing any longer; gone where no place of its start marking is left. */
    private Optional<TestCase> meaningful(TestCase testCase) {
        if (testCase.start().isEmpty()) {
            return Optional.of(steps(testCase));
        }
        String of = "the start of the test case \"" + testCase.name() + "\" of the plan \"" + plan.id() + "\"";
        TestStart start = testCase.start().get();
        List<StartMarking.Tokens> at = new ArrayList<>();
        for (StartMarking.Tokens tokens : start.marking().places()) {
            if (places.contains(tokens.place())) {
                at.add(tokens);
            } else {
                tell.accept("The tokens in " + tokens.place() + " went along from " + of + ": there is no such place");
            }
        }
        if (at.isEmpty()) {
            tell.accept("The test case \"" + testCase.name() + "\" of the plan \"" + plan.id()
                    + "\" went along: no place is left in which it could start");
            return Optional.empty();
        }
        Map<String, Value> values = new LinkedHashMap<>(start.values());
        start.values().forEach((key, value) -> {
            if (!steps.isAsked("", key, value)) {
                values.remove(key);
                tell.accept("The value of " + key + " went along from " + of + ": it is not asked");
            }
        });
        boolean same = at.size() == start.marking().places().size()
                && values.size() == start.values().size();
        return Optional.of(
                steps(same ? testCase : testCase.withStart(Optional.of(new TestStart(new StartMarking(at), values)))));
    }

    private TestCase steps(TestCase testCase) {
        List<TestStep> kept = new ArrayList<>();
        for (int i = 0; i < testCase.steps().size(); i++) {
            TestStep step = testCase.steps().get(i);
            int number = i + 1;
            steps.problem(step)
                    .ifPresentOrElse(
                            why -> tell.accept("Step " + number + " of the test case \"" + testCase.name()
                                    + "\" of the plan \"" + plan.id() + "\" went along: " + why),
                            () -> kept.add(step));
        }
        return kept.size() == testCase.steps().size() ? testCase : testCase.withSteps(kept);
    }
}
