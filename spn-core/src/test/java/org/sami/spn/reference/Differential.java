package org.sami.spn.reference;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.sami.spn.model.Project;
import org.sami.spn.protocol.Effect;
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
        return explore(seed, length, maker, new Coverage());
    }

    /** As the other, and counts which rules it exercised. */
    static Optional<Disagreement> explore(long seed, int length, Maker maker, Coverage coverage) {
        Project project = RandomPlans.project(seed);
        return explore(seed, length, maker, coverage, project, new RandomInputs(project, seed));
    }

    /** A random session in which projects are loaded. */
    static Optional<Disagreement> exploreLoading(long seed, int length, Maker maker, Coverage coverage) {
        Optional<Project> project = RandomLoads.readable(RandomPlans.project(seed));
        if (project.isEmpty()) {
            return Optional.empty();
        }
        RandomInputs world = new RandomInputs(project.get(), seed, RandomLoads.of(project.get(), seed));
        return explore(seed, length, maker, coverage, project.get(), world);
    }

    private static Optional<Disagreement> explore(
            long seed, int length, Maker maker, Coverage coverage, Project project, RandomInputs world) {
        Subject interpreter = interpreter(project);
        Subject other = maker.make(project);
        Following following = new Following();
        List<Scenario.Timed> inputs = new ArrayList<>();
        for (int i = 0; i < length; i++) {
            Scenario.Timed timed = world.next(interpreter);
            inputs.add(timed);
            try {
                List<Effect> expected = interpreter.step(timed.nowMillis(), timed.input());
                Optional<String> difference = step(interpreter, expected, other, following, timed);
                if (difference.isPresent()) {
                    return Optional.of(new Disagreement(new Scenario(seed, project, inputs), i, difference.get()));
                }
                world.saw(expected);
                coverage.saw(world.seen(), expected);
                world.askedOfDropped().ifPresent(coverage::droppedWhileAsked);
            } catch (World.TooManyTokens e) {
                return Optional.empty();
            }
        }
        return Optional.empty();
    }

    private static Optional<String> step(
            Subject interpreter, List<Effect> expected, Subject other, Following following, Scenario.Timed timed) {
        try {
            List<Effect> actual = other.step(timed.nowMillis(), timed.input());
            return Comparison.difference(interpreter, expected, other, actual)
                    .or(() -> following.difference(other, actual));
        } catch (RuntimeException | StackOverflowError e) {
            return Optional.of("The other throws " + stack(e));
        }
    }

    static Optional<Disagreement> run(Scenario scenario, Maker maker) {
        Subject interpreter = interpreter(scenario.project());
        Subject other = maker.make(scenario.project());
        Following following = new Following();
        for (int i = 0; i < scenario.inputs().size(); i++) {
            Scenario.Timed timed = scenario.inputs().get(i);
            List<Effect> expected = interpreter.step(timed.nowMillis(), timed.input());
            Optional<String> difference = step(interpreter, expected, other, following, timed);
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
}
