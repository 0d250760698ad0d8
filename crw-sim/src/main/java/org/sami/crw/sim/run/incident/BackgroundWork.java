package org.sami.crw.sim.run.incident;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.sami.crw.session.SessionOperator.Asked;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.HostListener;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;

/** When the operator does which action in the background. Answers to other questions take none of that time. For the engine's thread. */
final class BackgroundWork implements HostListener {
    private final BackgroundActions actions;
    private final Set<Long> noticing = new HashSet<>(); // activations of the place where incidents are noticed
    private final Deque<Segment> segments = new ArrayDeque<>();
    private long freeAtMillis;

    private record Segment(long activation, long fromMillis, long toMillis) {}

    BackgroundWork(BackgroundActions actions) {
        this.actions = actions;
    }

    @Override
    public void onStep(long index, long atMillis, Input input, List<Effect> effects, EngineView view) {
        for (Effect effect : effects) {
            if (effect instanceof Effect.Activated activated
                    && activated.activation().plan().equals(actions.plan())
                    && activated.activation().place().equals(actions.noticing())) {
                noticing.add(activated.activation().id());
            }
        }
    }

    /** How long an action waits until those that were asked for earlier are done; 0 for what is no action in the background. Called once for each. */
    long waitMillis(Asked asked) {
        if (actions.areNone() || !asked.plan().equals(actions.plan())) {
            return 0;
        }
        long from = Math.max(asked.atMillis(), freeAtMillis);
        freeAtMillis = from + asked.workMillis();
        segments.add(new Segment(asked.decision().activation(), from, freeAtMillis));
        return from - asked.atMillis();
    }

    /** Whether the operator would notice an incident now. */
    boolean isNoticing(long nowMillis) {
        if (actions.areNone()) {
            return true;
        }
        while (!segments.isEmpty() && segments.peek().toMillis() <= nowMillis) {
            noticing.remove(segments.poll().activation());
        }
        return !segments.isEmpty()
                && segments.peek().fromMillis() <= nowMillis
                && noticing.contains(segments.peek().activation());
    }
}
