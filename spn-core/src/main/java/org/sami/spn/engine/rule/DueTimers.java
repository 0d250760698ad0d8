package org.sami.spn.engine.rule;

import java.util.List;
import java.util.Map;
import org.sami.spn.engine.state.RunningTimer;
import org.sami.spn.engine.state.SentActivation;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.TaskId;
import org.sami.spn.vocabulary.EventRole;

/**
 * Timers and deadlines that have run down: each expires as an input of its own, with all that follows from it.
 *
 * <p>Implements R-DET-3.
 */
public final class DueTimers {
    private final RuleStep step;
    private final Timers timers;
    private final Routing routing;
    private final Decisions decisions;
    private final Firing firing;
    private final Runnable settle;

    /**
     * The timers of a state.
     *
     * @param settle works until nothing is left to do
     */
    DueTimers(RuleStep step, Timers timers, Routing routing, Decisions decisions, Firing firing, Runnable settle) {
        this.step = step;
        this.timers = timers;
        this.routing = routing;
        this.decisions = decisions;
        this.firing = firing;
        this.settle = settle;
    }

    /** Runs what is due until a time, each as an input of its own at its own time. */
    public void runUntil(long time) {
        firing.newChain();
        while (!step.state.timers.isEmpty() && step.state.timers.first().due() <= time) {
            RunningTimer next = step.state.timers.pollFirst();
            if (next.due() > step.state.now) {
                step.state.now = next.due();
                firing.newChain();
            }
            expire(next);
            settle.run();
        }
        step.state.now = Math.max(step.state.now, time);
    }

    private void expire(RunningTimer timer) {
        if (timer.isDeadline()) {
            decisions.deadline(step.state.decision(timer.decision()));
            return;
        }
        SentActivation sent = step.state.activationOf(timer);
        sent.timers.remove(timer);
        boolean perRobot = sent.output.role == EventRole.PROXY_TIMER;
        String type = step.project()
                .answerType(sent.output, perRobot ? EventRole.PROXY_TIMER_EXPIRED : EventRole.TIMER_EXPIRED);
        List<String> proxies = perRobot ? List.of(timers.robot(timer.token())) : List.of();
        List<TaskId> tasks = perRobot && timer.token() instanceof Token.Task task ? List.of(task.task()) : List.of();
        routing.route(Occurrence.answer(type, sent.activation, notEmpty(proxies), tasks, Map.of()));
    }

    private static List<String> notEmpty(List<String> proxies) {
        return proxies.contains("") ? List.of() : proxies;
    }
}
