package org.sami.lessons.progress;

/**
 * What a learner has done on a step.
 *
 * @param done whether it was read, answered rightly, or passed
 * @param attempts how often a quiz was answered or a job checked
 * @param rightAtOnce whether the first attempt was right
 * @param hints how many hints of a job were shown, the worked example included
 * @param solutionSeen whether the solution of a job was shown
 * @param millis how long the step was shown while the learner did something
 */
public record StepProgress(
        boolean done, int attempts, boolean rightAtOnce, int hints, boolean solutionSeen, long millis) {
    /** Nothing yet. */
    public static final StepProgress NONE = new StepProgress(false, 0, false, 0, false, 0);

    StepProgress read() {
        return new StepProgress(true, attempts, rightAtOnce, hints, solutionSeen, millis);
    }

    StepProgress attempted(boolean right) {
        return new StepProgress(
                done || right, attempts + 1, attempts == 0 ? right : rightAtOnce, hints, solutionSeen, millis);
    }

    StepProgress hinted() {
        return new StepProgress(done, attempts, rightAtOnce, hints + 1, solutionSeen, millis);
    }

    StepProgress solved() {
        return new StepProgress(done, attempts, rightAtOnce, hints, true, millis);
    }

    StepProgress spent(long more) {
        return new StepProgress(done, attempts, rightAtOnce, hints, solutionSeen, millis + more);
    }
}
