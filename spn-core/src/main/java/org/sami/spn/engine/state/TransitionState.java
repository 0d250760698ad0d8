package org.sami.spn.engine.state;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.sami.spn.engine.net.CompiledTransition;
import org.sami.spn.protocol.Token;

/** The pending occurrences of one transition of one mission: a list per input event, and an index by token. */
public final class TransitionState {
    /** Pending occurrences of one input event in order of arrival. */
    public static final class Queue {
        public @Nullable PendingOccurrence first;
        private @Nullable PendingOccurrence last;
        public int size;
        /** How many of them name somebody. */
        public int naming;
    }

    /** A name of a pending occurrence, as it is found by the tokens that it speaks of. */
    public record Speaking(PendingOccurrence pending, NamedToken name) {}

    public final MissionState mission;
    public final CompiledTransition transition;
    /** Whether it stands on the work list. */
    public boolean queued;

    public final Queue[] queues;
    public int pending;
    /** How many of them name nobody. */
    public int nameless;
    /** Counts who has reported, where the transition waits for all; else null. */
    public final @Nullable Barrier barrier;

    private final Map<Token, List<Speaking>> index = new HashMap<>(4);

    public TransitionState(MissionState mission, CompiledTransition transition) {
        this.mission = mission;
        this.transition = transition;
        this.queues = new Queue[transition.inputs.length];
        for (int i = 0; i < queues.length; i++) {
            queues[i] = new Queue();
        }
        this.barrier = transition.waitsForAll ? new Barrier(queues.length) : null;
    }

    /** Counts who has reported; only where the transition waits for all. */
    public Barrier allReports() {
        return Objects.requireNonNull(barrier, "the barrier of a transition that waits for one");
    }

    public void add(PendingOccurrence p) {
        Queue q = queues[p.input.index];
        p.previous = q.last;
        if (q.last == null) {
            q.first = p;
        } else {
            q.last.next = p;
        }
        q.last = p;
        q.size++;
        pending++;
        if (p.names.length == 0) {
            nameless++;
        } else {
            q.naming++;
            for (NamedToken n : p.names) {
                if (!n.struck) {
                    index(p, n);
                }
            }
        }
    }

    public void remove(PendingOccurrence p) {
        Queue q = queues[p.input.index];
        if (p.previous == null) {
            q.first = p.next;
        } else {
            p.previous.next = p.next;
        }
        if (p.next == null) {
            q.last = p.previous;
        } else {
            p.next.previous = p.previous;
        }
        p.removed = true;
        q.size--;
        pending--;
        if (p.names.length == 0) {
            nameless--;
        } else {
            q.naming--;
            for (NamedToken n : p.names) {
                if (!n.struck) {
                    unindex(p, n);
                }
            }
        }
    }

    public void strike(PendingOccurrence p, NamedToken n) {
        unindex(p, n);
        n.struck = true;
        p.namesLeft--;
    }

    /** Replaces the tokens that a name speaks of, after an allocation changed. */
    public void renew(PendingOccurrence p, NamedToken n, Token[] tokens) {
        unindex(p, n);
        n.tokens = tokens;
        index(p, n);
    }

    /** Names that speak of a token and are not struck. */
    public List<Speaking> speakingOf(Token token) {
        return index.getOrDefault(token, List.of());
    }

    private void index(PendingOccurrence p, NamedToken n) {
        Speaking speaking = new Speaking(p, n);
        for (Token token : n.tokens) {
            List<Speaking> list = index.get(token);
            if (list == null) {
                list = new ArrayList<>(2);
                index.put(token, list);
            }
            list.add(placeIn(list, p.input.index), speaking);
            if (barrier != null) {
                barrier.reported(p.input.index, token);
            }
        }
    }

    /** By input event, then by arrival: the order in which a state is written and read, so that both strike in the same order. */
    private static int placeIn(List<Speaking> list, int input) {
        int at = list.size();
        while (at > 0 && list.get(at - 1).pending.input.index > input) {
            at--;
        }
        return at;
    }

    private void unindex(PendingOccurrence p, NamedToken n) {
        for (Token token : n.tokens) {
            List<Speaking> list = speakingOf(token);
            if (list.size() == 1) {
                index.remove(token);
            } else {
                list.removeIf(speaking -> speaking.name == n);
            }
            if (barrier != null) {
                barrier.withdrawn(p.input.index, token);
            }
        }
    }
}
