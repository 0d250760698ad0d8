package org.sami.spn.stepping;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.sami.spn.engine.EngineView;
import org.sami.spn.engine.MissionView;
import org.sami.spn.model.TestStep;
import org.sami.spn.naming.ElementNames;
import org.sami.spn.protocol.Outcome;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.TaskId;

/** Whether what a test case expects is so at one moment, in words where it is not, and what it could expect. */
final class Expectations {
    private final Moment moment;
    private final EngineView view;

    Expectations(Moment moment, EngineView view) {
        this.moment = moment;
        this.view = view;
    }

    Optional<String> ended() {
        return moment.outcome.isPresent() && moment.outcome.get() == Outcome.ENDED
                ? Optional.empty()
                : Optional.of("the mission has not ended; tokens stand in "
                        + marking().keySet().stream().map(this::name).toList());
    }

    Optional<String> tokens(TestStep.ExpectTokens s) {
        List<Token> expected = new ArrayList<>(Collections.nCopies(s.generic(), Token.GENERIC));
        s.proxies().forEach(p -> expected.add(new Token.Proxy(p)));
        s.tasks().forEach(task -> expected.add(new Token.Task(new TaskId(moment.mission, task))));
        List<Token> found = marking().getOrDefault(s.place(), List.of());
        return count(expected).equals(count(found))
                ? Optional.empty()
                : Optional.of("expected in " + name(s.place()) + " are " + words(expected) + ", found " + words(found));
    }

    /** What stands in a place now, as an expectation. */
    TestStep.ExpectTokens found(String place) {
        List<Token> found = marking().getOrDefault(place, List.of());
        return new TestStep.ExpectTokens(
                place,
                Collections.frequency(found, Token.GENERIC),
                found.stream()
                        .filter(Token.Proxy.class::isInstance)
                        .map(t -> ((Token.Proxy) t).proxy())
                        .toList(),
                found.stream()
                        .filter(Token.Task.class::isInstance)
                        .map(t -> ((Token.Task) t).task().name())
                        .toList());
    }

    private Map<String, List<Token>> marking() {
        return view.mission(moment.mission).map(MissionView::marking).orElse(Map.of());
    }

    private String name(String place) {
        return view.planOf(moment.mission)
                .flatMap(plan -> new ElementNames(plan, view.vocabulary()).of(place))
                .orElse(place);
    }

    private static Map<Token, Long> count(List<Token> tokens) {
        return tokens.stream().collect(Collectors.groupingBy(Function.identity(), Collectors.counting()));
    }

    private static String words(List<Token> tokens) {
        return tokens.isEmpty()
                ? "no tokens"
                : tokens.stream().map(Expectations::word).collect(Collectors.joining(", "));
    }

    private static String word(Token token) {
        if (token instanceof Token.Proxy proxy) {
            return proxy.proxy();
        }
        return token instanceof Token.Task task ? task.task().name() : "generic";
    }
}
