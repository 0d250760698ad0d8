package org.sami.lessons.job;

import com.fasterxml.jackson.annotation.JsonIgnore;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.sami.spn.model.TestCase;

/**
 * What the grader says of a plan.
 *
 * @param passed whether the job is done
 * @param stage how far the plan came
 * @param words what is wrong, in a sentence or two; what is so where it passed
 * @param explained the step that explains it, as {@code LESSON/STEP}
 * @param elements ids of what is concerned in the graded plan, for highlighting
 * @param failedCase the name of the hidden case that went wrong
 * @param steps that case as it went, one line a step
 * @param run that case, to be played in the editor
 */
public record Verdict(
        boolean passed,
        Stage stage,
        String words,
        Optional<String> explained,
        List<String> elements,
        Optional<String> failedCase,
        List<String> steps,
        @JsonIgnore Optional<TestCase> run) {
    /** How far a plan came: the first stage where something was wrong. */
    public enum Stage {
        /** The file, or what the job says of its plan. */
        FILE,
        /** The checks of plans. */
        CHECKS,
        /** What is asked to be used. */
        USES,
        /** The hidden cases. */
        CASES,
        /** Everything is right. */
        PASSED
    }

    public Verdict {
        Objects.requireNonNull(stage, "stage");
        Objects.requireNonNull(words, "words");
        Objects.requireNonNull(explained, "explained");
        elements = List.copyOf(elements);
        Objects.requireNonNull(failedCase, "failedCase");
        steps = List.copyOf(steps);
        Objects.requireNonNull(run, "run");
    }

    static Verdict right(String words) {
        return new Verdict(
                true, Stage.PASSED, words, Optional.empty(), List.of(), Optional.empty(), List.of(), Optional.empty());
    }

    /** A plan that is wrong without having run. */
    public static Verdict wrong(Stage stage, String words, List<String> elements) {
        return new Verdict(
                false, stage, words, Optional.empty(), elements, Optional.empty(), List.of(), Optional.empty());
    }

    Verdict explainedBy(Optional<String> step) {
        return new Verdict(passed, stage, words, step, elements, failedCase, steps, run);
    }

    Verdict saying(String other) {
        return new Verdict(passed, stage, other, explained, elements, failedCase, steps, run);
    }

    Verdict showing(String name, List<String> lines, TestCase played) {
        return new Verdict(passed, stage, words, explained, elements, Optional.of(name), lines, Optional.of(played));
    }
}
