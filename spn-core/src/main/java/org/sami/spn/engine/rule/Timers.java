package org.sami.spn.engine.rule;

import java.util.List;
import org.sami.spn.engine.state.OpenDecision;
import org.sami.spn.engine.state.RunningTimer;
import org.sami.spn.engine.state.SentActivation;
import org.sami.spn.engine.state.TaskState;
import org.sami.spn.engine.state.Visit;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.NoteKind;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.DurationValue;
import org.sami.spn.vocabulary.EventRole;
import org.sami.spn.vocabulary.Reserved;

/**
 * Timers of activations and deadlines of decisions; cancelled with their visits.
 *
 * <p>Implements R-VIS-6.
 */
public final class Timers {
    private final RuleStep step;

    Timers(RuleStep step) {
        this.step = step;
    }

    /** Starts the timers of an activation: one, or one per entering robot. */
    public void start(SentActivation sent) {
        long millis = sent.activation
                .value(Reserved.DURATION)
                .map(v -> v instanceof DurationValue d ? d.millis() : -1L)
                .orElse(-1L);
        if (millis < 0) {
            step.note(
                    NoteKind.HANDLER_FAILED,
                    sent.mission().id,
                    sent.activation.type() + " at '" + sent.visit.place.place
                            + "' has no duration: no timer is started");
            return;
        }
        if (sent.output.role == EventRole.TIMER) {
            add(millis, sent, Token.GENERIC);
            return;
        }
        for (Token token : sent.activation.tokens()) {
            if (!robot(token).isEmpty() && !hasTimer(sent, token)) {
                add(millis, sent, token);
            }
        }
    }

    private static boolean hasTimer(SentActivation sent, Token token) {
        return sent.timers.stream().anyMatch(t -> t.token().equals(token));
    }

    public RunningTimer deadline(OpenDecision open, long millis) {
        return add(millis, Ids.NONE, Token.GENERIC, open.decision.id());
    }

    private void add(long millis, SentActivation sent, Token token) {
        sent.add(add(millis, sent.activation.id(), token, Ids.NONE));
    }

    private RunningTimer add(long millis, long activation, Token token, long decision) {
        RunningTimer timer =
                new RunningTimer(step.state.now + millis, ++step.state.lastTimer, activation, token, decision);
        step.state.timers.add(timer);
        return timer;
    }

    public void cancel(RunningTimer timer) {
        step.state.timers.remove(timer);
    }

    public void cancelAll(SentActivation sent) {
        for (RunningTimer t : sent.timers) {
            step.state.timers.remove(t);
        }
        sent.timers = List.of();
    }

    /** A token left its visit: its own timers end. */
    public void tokenLeft(Visit v, Token token) {
        for (SentActivation sent = v.firstSent(); sent != null; sent = sent.next()) {
            if (!sent.timers.isEmpty() && !v.has(token)) {
                sent.timers.removeIf(t -> t.token().equals(token) && step.state.timers.remove(t));
            }
        }
    }

    /** The robot of a token; empty text where it has none. */
    String robot(Token token) {
        if (token instanceof Token.Proxy proxy) {
            return proxy.proxy();
        }
        if (token instanceof Token.Task task) {
            TaskState state = step.task(task.task());
            return state == null ? "" : state.proxy();
        }
        return "";
    }
}
