package org.sami.spn.engine.rule;

import java.util.List;
import java.util.Map;
import org.sami.spn.engine.state.OpenDecision;
import org.sami.spn.engine.state.RunningTimer;
import org.sami.spn.engine.state.SentActivation;
import org.sami.spn.engine.state.TaskState;
import org.sami.spn.engine.state.Visit;
import org.sami.spn.protocol.NoteKind;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.DurationValue;
import org.sami.spn.value.TaskId;
import org.sami.spn.vocabulary.EventRole;
import org.sami.spn.vocabulary.Reserved;

/**
 * Timers of activations and deadlines of decisions; cancelled with their visits.
 *
 * <p>Implements R-VIS-6, R-DET-3.
 */
public final class Timers {
    private final Rules rules;

    public Timers(Rules rules) {
        this.rules = rules;
    }

    /** Starts the timers of an activation: one, or one per entering robot. */
    public void start(SentActivation sent) {
        long millis = sent.activation
                .value(Reserved.DURATION)
                .map(v -> v instanceof DurationValue d ? d.millis() : -1L)
                .orElse(-1L);
        if (millis < 0) {
            rules.note(
                    NoteKind.HANDLER_FAILED,
                    sent.mission().id,
                    sent.activation.type() + " at '" + sent.visit.place.place
                            + "' has no duration: no timer is started");
            return;
        }
        if (sent.output.role == EventRole.TIMER) {
            add(millis, sent, Token.GENERIC, null);
            return;
        }
        for (Token token : sent.activation.tokens()) {
            if (!robot(token).isEmpty() && !hasTimer(sent, token)) {
                add(millis, sent, token, null);
            }
        }
    }

    private static boolean hasTimer(SentActivation sent, Token token) {
        return sent.timers.stream().anyMatch(t -> t.token().equals(token));
    }

    public RunningTimer deadline(OpenDecision decision, long millis) {
        return add(millis, null, null, decision);
    }

    private RunningTimer add(long millis, SentActivation sent, Token token, OpenDecision decision) {
        RunningTimer timer = new RunningTimer(rules.state.now + millis, ++rules.state.lastTimer, sent, token, decision);
        rules.state.timers.add(timer);
        if (sent != null) {
            sent.add(timer);
        }
        return timer;
    }

    public void cancel(RunningTimer timer) {
        rules.state.timers.remove(timer);
    }

    public void cancelAll(SentActivation sent) {
        for (RunningTimer t : sent.timers) {
            rules.state.timers.remove(t);
        }
        sent.timers = List.of();
    }

    /** A token left its visit: its own timers end. */
    public void tokenLeft(Visit v, Token token) {
        for (SentActivation sent : v.sent) {
            if (!sent.timers.isEmpty() && !v.has(token)) {
                sent.timers.removeIf(t -> t.token().equals(token) && rules.state.timers.remove(t));
            }
        }
    }

    /** Runs what is due until a time, each as an input of its own at its own time. */
    public void runUntil(long time) {
        rules.firing.newChain();
        while (!rules.state.timers.isEmpty() && rules.state.timers.first().due() <= time) {
            RunningTimer next = rules.state.timers.pollFirst();
            if (next.due() > rules.state.now) {
                rules.state.now = next.due();
                rules.firing.newChain();
            }
            expire(next);
            rules.settle();
        }
        rules.state.now = Math.max(rules.state.now, time);
    }

    private void expire(RunningTimer timer) {
        if (timer.decision() != null) {
            rules.decisions.deadline(timer.decision());
            return;
        }
        SentActivation sent = timer.sent();
        sent.timers.remove(timer);
        boolean perRobot = sent.output.role == EventRole.PROXY_TIMER;
        String type =
                rules.activating.answerType(sent, perRobot ? EventRole.PROXY_TIMER_EXPIRED : EventRole.TIMER_EXPIRED);
        List<String> proxies = perRobot ? List.of(robot(timer.token())) : List.of();
        List<TaskId> tasks = perRobot && timer.token() instanceof Token.Task task ? List.of(task.task()) : List.of();
        rules.routing.route(Occurrence.answer(type, sent.activation, notEmpty(proxies), tasks, Map.of()));
    }

    private static List<String> notEmpty(List<String> proxies) {
        return proxies.contains("") ? List.of() : proxies;
    }

    private String robot(Token token) {
        if (token instanceof Token.Proxy proxy) {
            return proxy.proxy();
        }
        if (token instanceof Token.Task task) {
            TaskState state = rules.task(task.task());
            return state == null ? "" : state.proxy();
        }
        return "";
    }
}
