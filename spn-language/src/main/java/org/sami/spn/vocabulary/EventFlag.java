package org.sami.spn.vocabulary;

/** Marks that change how an event's occurrences are treated. */
public enum EventFlag {
    /** Frequent news, such as pose updates: only the latest per proxy counts; unwanted ones are counted, not recorded. */
    COALESCE,
    /** An output event that occupies its robots: a motion command. Used by the checks and by withdrawal reports. */
    COMMAND,
    /** An input event that also comes without being asked for: it needs no output event before its transition. */
    NEWS,
    /** An output event that plans may send without waiting for its answers. */
    ANSWER_OPTIONAL,
    /** An input event that says that what was asked failed, or of a danger: a plan that asks is warned where it does not wait for it. */
    FAILURE,
    /** News that a robot has begun with a task: it comes by itself when the task is the first that its robot has left. */
    TASK_STARTED,
    /** An input event that says that tasks are complete: each of their robots goes on with its next. */
    TASK_COMPLETED,
    /** An input event that says that all is well: a plan that takes robots from their work for it is warned. */
    NOMINAL
}
