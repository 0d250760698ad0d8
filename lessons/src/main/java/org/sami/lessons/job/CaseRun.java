package org.sami.lessons.job;

import java.util.List;
import java.util.Objects;
import java.util.OptionalLong;
import org.sami.spn.model.TestCase;

/**
 * One run of a hidden case: what could be seen of it from outside.
 *
 * @param trace the output events, in order of time; those of one instant in an order that does not depend on the plan
 * @param answers the input events that operator, robots and services posted, in order of time
 * @param questions how often the operator was asked something
 * @param endMillis when it ended, or was stopped
 * @param refusal why the plan could not start; empty text where it did
 * @param played the run, to be played in the editor
 */
public record CaseRun(
        List<TraceItem> trace,
        List<TraceItem> answers,
        int questions,
        End end,
        long endMillis,
        String refusal,
        TestCase played) {
    /** How a run came to its end. */
    public enum End {
        /** The mission ended by an end place. */
        ENDED,
        /** The mission was aborted or completed. */
        ABORTED,
        /** Nothing happens any more, and the mission has not ended. */
        WAITS,
        /** It still went on when the time of the case was over. */
        GOES_ON,
        /** It never comes to rest: transitions fire without end, tokens pile up, or more happens than in any sensible run. */
        ENDLESS,
        /** The plan could not start. */
        REFUSED
    }

    public CaseRun {
        trace = List.copyOf(trace);
        answers = List.copyOf(answers);
        Objects.requireNonNull(end, "end");
        Objects.requireNonNull(refusal, "refusal");
        Objects.requireNonNull(played, "played");
    }

    /** When an output event first happened. */
    OptionalLong firstOf(String event) {
        return trace.stream()
                .filter(item -> item.type().equals(event))
                .mapToLong(TraceItem::atMillis)
                .min();
    }

    /** When an input event was last received. */
    OptionalLong lastAnswer(String event) {
        return answers.stream()
                .filter(item -> item.type().equals(event))
                .mapToLong(TraceItem::atMillis)
                .max();
    }

    boolean hasEnded() {
        return end == End.ENDED || end == End.ABORTED;
    }

    /** The trace of certain output events; of all where none is named. */
    List<TraceItem> watched(List<String> types) {
        return types.isEmpty()
                ? trace
                : trace.stream().filter(item -> types.contains(item.type())).toList();
    }
}
