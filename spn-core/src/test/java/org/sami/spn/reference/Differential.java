package org.sami.spn.reference;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.sami.spn.model.Project;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Priority;
import org.sami.spn.testing.TestVocabulary;

/** Runs one scenario on the interpreter and on another subject, and compares after each input. */
final class Differential {
    /** Makes the other subject for a project. */
    interface Maker {
        Subject make(Project project);
    }

    /**
     * Where the two differ first.
     *
     * @param index of the input after which they differ
     */
    record Disagreement(Scenario scenario, int index, String what) {}

    private Differential() {}

    static Subject interpreter(Project project) {
        return new ReferenceInterpreter(TestVocabulary.TEST, project, Scenario.LIVELOCK_LIMIT);
    }

    /** A random session of so many inputs on both at once. */
    static Optional<Disagreement> explore(long seed, int length, Maker maker) {
        Project project = RandomPlans.project(seed);
        Subject interpreter = interpreter(project);
        Subject other = maker.make(project);
        RandomInputs world = new RandomInputs(project, seed);
        List<Scenario.Timed> inputs = new ArrayList<>();
        for (int i = 0; i < length; i++) {
            Scenario.Timed timed = world.next(interpreter);
            inputs.add(timed);
            try {
                List<Effect> expected = interpreter.step(timed.nowMillis(), timed.input());
                Optional<String> difference = step(interpreter, expected, other, timed);
                if (difference.isPresent()) {
                    return Optional.of(new Disagreement(new Scenario(seed, project, inputs), i, difference.get()));
                }
                world.saw(expected);
            } catch (World.TooManyTokens e) {
                return Optional.empty();
            }
        }
        return Optional.empty();
    }

    private static Optional<String> step(
            Subject interpreter, List<Effect> expected, Subject other, Scenario.Timed timed) {
        try {
            List<Effect> actual = other.step(timed.nowMillis(), timed.input());
            return difference(interpreter, expected, other, actual);
        } catch (RuntimeException | StackOverflowError e) {
            return Optional.of("The other throws " + stack(e));
        }
    }

    static Optional<Disagreement> run(Scenario scenario, Maker maker) {
        Subject interpreter = interpreter(scenario.project());
        Subject other = maker.make(scenario.project());
        for (int i = 0; i < scenario.inputs().size(); i++) {
            Scenario.Timed timed = scenario.inputs().get(i);
            List<Effect> expected = interpreter.step(timed.nowMillis(), timed.input());
            Optional<String> difference = step(interpreter, expected, other, timed);
            if (difference.isPresent()) {
                return Optional.of(new Disagreement(scenario, i, difference.get()));
            }
        }
        return Optional.empty();
    }

    private static String stack(Throwable e) {
        return e + " at "
                + Stream.of(e.getStackTrace()).limit(6).map(Object::toString).toList();
    }

    // ---- What must be equal

    private static Optional<String> difference(
            Subject interpreter, List<Effect> expected, Subject other, List<Effect> actual) {
        return Stream.of(
                        compare("missions that began", begun(expected), begun(actual)),
                        compare("firings", firings(expected), firings(actual)),
                        compare("activations", activations(expected), activations(actual)),
                        compare("missions that ended", ended(expected), ended(actual)),
                        compare("markings", interpreter.markings(), other.markings()),
                        compare("statuses", interpreter.statuses(), other.statuses()),
                        compare("variables written", written(expected), written(actual)),
                        compare("decisions opened", opened(expected), opened(actual)),
                        compare("open activations", interpreter.openActivations(), other.openActivations()),
                        compare("open decisions", interpreter.openDecisions(), other.openDecisions()),
                        compare("next due time", interpreter.nextDueMillis(), other.nextDueMillis()))
                .flatMap(Optional::stream)
                .reduce((a, b) -> a + "\n" + b);
    }

    private static Optional<String> compare(String what, Object expected, Object actual) {
        return expected.equals(actual)
                ? Optional.empty()
                : Optional.of("  " + what + "\n    interpreter: " + expected + "\n    other:       " + actual);
    }

    private static List<String> begun(List<Effect> effects) {
        List<String> found = new ArrayList<>();
        for (Effect effect : effects) {
            if (effect instanceof Effect.MissionStarted m) {
                found.add(m.mission() + " of " + m.parent() + " runs " + m.plan());
            }
        }
        return found;
    }

    private static List<String> firings(List<Effect> effects) {
        List<String> found = new ArrayList<>();
        for (Effect effect : effects) {
            if (effect instanceof Effect.Fired f) {
                found.add("#" + f.firing() + " mission " + f.mission() + " " + f.transition() + " with "
                        + f.used().stream().map(Differential::word).toList());
            }
        }
        return found;
    }

    /** Without the activation: news to all can be an answer in one mission. */
    private static String word(Occurrence o) {
        return o.type() + o.proxies() + o.tasks() + o.values();
    }

    private static List<Activation> activations(List<Effect> effects) {
        List<Activation> found = new ArrayList<>();
        for (Effect effect : effects) {
            if (effect instanceof Effect.Activated a) {
                found.add(withoutPriority(a.activation()));
            }
        }
        return found;
    }

    private static Activation withoutPriority(Activation a) {
        return new Activation(
                a.id(),
                a.mission(),
                a.rootMission(),
                a.visit(),
                a.plan(),
                a.place(),
                a.event(),
                a.type(),
                a.values(),
                a.taskValues(),
                a.tokens(),
                a.allocation(),
                a.markups(),
                Priority.MEDIUM);
    }

    private static List<String> ended(List<Effect> effects) {
        List<String> found = new ArrayList<>();
        for (Effect effect : effects) {
            if (effect instanceof Effect.MissionEnded m) {
                found.add(m.mission() + " " + m.outcome());
            }
        }
        return found.stream().sorted().toList();
    }

    private static List<Map.Entry<String, Object>> written(List<Effect> effects) {
        List<Map.Entry<String, Object>> found = new ArrayList<>();
        for (Effect effect : effects) {
            if (effect instanceof Effect.VariableWritten w) {
                found.add(Map.entry(w.mission() + " " + w.variable(), w.value()));
            }
        }
        return found;
    }

    private static List<String> opened(List<Effect> effects) {
        List<String> found = new ArrayList<>();
        for (Effect effect : effects) {
            if (effect instanceof Effect.DecisionOpened d) {
                Decision decision = d.decision();
                found.add(decision.id() + " of mission " + decision.mission() + " for activation "
                        + decision.activation() + " "
                        + decision.question().getClass().getSimpleName() + " until " + decision.deadlineMillis());
            }
        }
        return found;
    }
}
