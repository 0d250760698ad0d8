package org.sami.spn.vocabulary;

/**
 * What the engine itself does with an event. Everything else about an event is done by the handlers of its domain. The
 * fields that a role reads or fills have the fixed names given here.
 */
public enum EventRole {
    /** Nothing: a handler or a decision answers. */
    NONE,
    /** Output: starts one timer per activation; field {@code duration}. */
    TIMER,
    /** Output: starts one timer per entering proxy (or task with a proxy); field {@code duration}. */
    PROXY_TIMER,
    /** Input: a timer of the mission has run down; names nobody. */
    TIMER_EXPIRED,
    /** Input: a proxy's timer has run down; names that proxy, and the task whose token started it. */
    PROXY_TIMER_EXPIRED,
    /** Output: the engine answers at once with {@link #TOKENS_RETURNED}, naming every proxy known now. */
    GET_ALL_TOKENS,
    /** Input: answer to {@link #GET_ALL_TOKENS}. */
    TOKENS_RETURNED,
    /** Input: a named interrupt, a button while its mission runs; field {@code interruptName} (appendix .2.2). */
    INTERRUPT,
    /** Output: enables a general interrupt (thesis 7.0.2); field {@code interruptName}. */
    GENERAL_INTERRUPT,
    /** Input: the general interrupt of one of its in places was pressed. */
    GENERAL_INTERRUPT_RECEIVED,
    /** Output: enables a proxy interrupt (thesis 7.0.2); field {@code interruptName}. */
    PROXY_INTERRUPT,
    /** Input: the proxy interrupt was pressed; names the chosen proxies. */
    PROXY_INTERRUPT_RECEIVED,
    /** Output: asks for the mission's abort. */
    ABORT_MISSION,
    /** Input: intercepts the abort of its mission. */
    ABORT_RECEIVED,
    /** Output: asks for the mission's completion. */
    COMPLETE_MISSION,
    /** Input: intercepts the completion of its mission. */
    COMPLETE_RECEIVED,
    /** Input: a dynamic or static child was aborted; names its starting tokens. */
    SUB_MISSION_ABORTED,
    /** Output: sets the return value of the (sub-)mission; field {@code value}. */
    RETURN_VALUE,
    /**
     * Input: the return value of an instance on an in place equals the field {@code value}. It is looked at when the
     * instance completes.
     */
    CHECK_RETURN,
    /**
     * Output: adds tasks to the mission, one per item of the list in the field {@code locations}, of the class in the
     * field {@code taskClass}; the engine answers with {@link #TASKS_GENERATED}, naming them.
     */
    GENERATE_TASKS,
    /** Input: answer to {@link #GENERATE_TASKS}. */
    TASKS_GENERATED,
    /** Output: applies the task allocation (map from task to proxy) in the field {@code tasks}. */
    APPLY_ALLOCATION;

    /** Input events whose occurrences are never kept: the transition fires now or refuses them. */
    public boolean isPress() {
        return this == ABORT_RECEIVED || this == COMPLETE_RECEIVED || isInterrupt();
    }

    /** Whether an input event is the press of an interrupt's button. */
    public boolean isInterrupt() {
        return this == INTERRUPT || this == GENERAL_INTERRUPT_RECEIVED || this == PROXY_INTERRUPT_RECEIVED;
    }
}
