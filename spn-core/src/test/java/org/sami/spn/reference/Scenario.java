package org.sami.spn.reference;

import java.util.ArrayList;
import java.util.List;
import org.sami.spn.model.Project;
import org.sami.spn.protocol.Input;
import org.sami.spn.testing.TestVocabulary;

/** A project and what happens to it. */
record Scenario(long seed, Project project, List<Timed> inputs) {
    /** Short, so that random rings end soon. */
    static final int LIVELOCK_LIMIT = 25;

    /** An input with the session's time. */
    record Timed(long nowMillis, Input input) {}

    Scenario {
        inputs = List.copyOf(inputs);
    }

    /** A random project, and inputs that answer what the interpreter asks. */
    static Scenario random(long seed, int length) {
        Project project = RandomPlans.project(seed);
        Subject interpreter = new ReferenceInterpreter(TestVocabulary.TEST, project, LIVELOCK_LIMIT);
        RandomInputs world = new RandomInputs(seed);
        List<Timed> inputs = new ArrayList<>();
        for (int i = 0; i < length; i++) {
            Timed timed = new Timed(world.nextTime(interpreter), world.next(interpreter));
            try {
                world.saw(interpreter.step(timed.nowMillis(), timed.input()));
            } catch (World.TooManyTokens e) {
                break; // up to the input before
            }
            inputs.add(timed);
        }
        return new Scenario(seed, project, inputs);
    }

    Scenario with(Project otherProject) {
        return new Scenario(seed, otherProject, inputs);
    }

    Scenario with(List<Timed> otherInputs) {
        return new Scenario(seed, project, otherInputs);
    }
}
