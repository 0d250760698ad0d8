package org.sami.lessons.job;

import java.util.Optional;

/**
 * A hidden case with the learner's plan and with the solution.
 *
 * @param difference the first difference in a sentence; empty where they are the same
 */
record CaseOutcome(JobCase job, CaseRun run, CaseRun right, Optional<String> difference) {
    static CaseOutcome of(JobCase job, CaseRun run, CaseRun right, TraceWords words) {
        return new CaseOutcome(job, run, right, new TraceDifference(job, run, right, words).sentence());
    }

    boolean isSame() {
        return difference.isEmpty();
    }

    boolean went(CaseEnd how) {
        boolean rightEnds = right.hasEnded();
        return switch (how) {
            case SAME -> isSame();
            case DIFFERENT -> !isSame();
            case NEVER_ENDS -> rightEnds && !run.hasEnded();
            case ENDS_EARLY -> run.hasEnded() && (!rightEnds || run.endMillis() < right.endMillis());
            case ASKS_NOBODY -> run.questions() == 0 && right.questions() > 0;
            case ENDLESS -> run.end() == CaseRun.End.ENDLESS;
            case REFUSED -> run.end() == CaseRun.End.REFUSED;
        };
    }

    /** What to say of it: the words of the first expectation that does not hold, else the first difference. */
    String words() {
        return job.expect().stream()
                .filter(expect -> !expect.wanted().holds(run))
                .map(JobCase.Expect::otherwise)
                .findFirst()
                .or(() -> difference)
                .orElse("");
    }
}
