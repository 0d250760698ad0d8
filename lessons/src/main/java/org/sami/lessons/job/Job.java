package org.sami.lessons.job;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;

/**
 * A job of a lesson: a plan that the learner makes or changes, and how it is graded (docs/writing-a-lesson.md).
 *
 * @param id the name of its file
 * @param start the plan file that the learner begins with
 * @param plan id of the plan that is graded
 * @param solution a right plan, for the traces of the hidden cases
 * @param isComputed whether the requirements of all edges are computed anew before a plan runs
 * @param ignored codes of findings that do not count
 * @param uses what is asked to be used
 * @param cases the hidden cases
 * @param mistakes known errors, the most particular first
 * @param hints a first hint, then stronger ones
 * @param example the pattern on another plan
 */
public record Job(
        String id,
        String start,
        String plan,
        Solution solution,
        boolean isComputed,
        Set<String> ignored,
        List<Use> uses,
        List<JobCase> cases,
        List<Mistake> mistakes,
        List<String> hints,
        Optional<Example> example) {
    /** The version of the format of job files. */
    public static final int FORMAT_VERSION = 1;

    public Job {
        Objects.requireNonNull(id, "id");
        Objects.requireNonNull(start, "start");
        Objects.requireNonNull(plan, "plan");
        Objects.requireNonNull(solution, "solution");
        ignored = Set.copyOf(ignored);
        uses = List.copyOf(uses);
        cases = List.copyOf(cases);
        mistakes = List.copyOf(mistakes);
        hints = List.copyOf(hints);
        Objects.requireNonNull(example, "example");
    }

    /** The hidden case of a name. */
    public Optional<JobCase> caseNamed(String name) {
        return cases.stream().filter(one -> one.name().equals(name)).findFirst();
    }

    /**
     * A right plan: a plan file, or edits of one.
     *
     * @param from a plan file
     * @param script the elements of an edit script; none where the file itself is right
     */
    public record Solution(String from, List<JsonNode> script) {
        public Solution {
            Objects.requireNonNull(from, "from");
            script = List.copyOf(script);
        }
    }

    /**
     * Something that the plan is asked to use.
     *
     * @param otherwise what is said where it does not
     */
    public record Use(JobPredicate predicate, String otherwise, Optional<String> explained) {
        public Use {
            Objects.requireNonNull(predicate, "predicate");
            Objects.requireNonNull(otherwise, "otherwise");
            Objects.requireNonNull(explained, "explained");
        }
    }

    /**
     * A known error.
     *
     * @param when all of it holds where the error was made
     * @param explained the step that explains it: {@code STEP}, or {@code LESSON/STEP}
     */
    public record Mistake(List<JobPredicate> when, String say, Optional<String> explained) {
        public Mistake {
            when = List.copyOf(when);
            Objects.requireNonNull(say, "say");
            Objects.requireNonNull(explained, "explained");
        }
    }

    /** The pattern of a job on another plan. */
    public record Example(String plan, List<String> text) {
        public Example {
            Objects.requireNonNull(plan, "plan");
            text = List.copyOf(text);
        }
    }
}
