package org.sami.spn.engine.state;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.sami.spn.engine.net.CompiledTransition;
import org.sami.spn.protocol.Token;

/** The pending occurrences of one transition of one mission: a list per input event, and an index by token. */
public final class TransitionState {
    /** Pending occurrences of one input event in order of arrival. */
    public static final class Queue {
        public PendingOccurrence first;
        private PendingOccurrence last;
        public int size;
        /** How many of them name somebody. */
        public int naming;
    }

    public final MissionState mission;
    public final CompiledTransition transition;
    /** Whether it stands on the work list. */
    public boolean queued;

    public final Queue[] queues;
    public int pending;
    /** How many of them name nobody. */
    public int nameless;
    /** Counts who has reported, where the transition waits for all; else null. */
    public final Barrier barrier;

    private final Map<Token, List<NamedToken>> index = new HashMap<>(4);

    public TransitionState(MissionState mission, CompiledTransition transition) {
        this.mission = mission;
        this.transition = transition;
        this.queues = new Queue[transition.inputs.length];
        for (int i = 0; i < queues.length; i++) {
            queues[i] = new Queue();
        }
        this.barrier = transition.waitsForAll ? new Barrier(queues.length) : null;
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
                    index(n);
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
                    unindex(n);
                }
            }
        }
    }

    public void strike(NamedToken n) {
        unindex(n);
        n.struck = true;
        n.pending.namesLeft--;
    }

    /** Replaces the tokens that a name speaks of, after an allocation changed. */
    public void renew(NamedToken n, Token[] tokens) {
        unindex(n);
        n.tokens = tokens;
        index(n);
    }

    /** Names that speak of a token and are not struck. */
    public List<NamedToken> speakingOf(Token token) {
        return index.getOrDefault(token, List.of());
    }

    private void index(NamedToken n) {
        for (Token token : n.tokens) {
            List<NamedToken> list = index.get(token);
            if (list == null) {
                list = new ArrayList<>(2);
                index.put(token, list);
            }
            list.add(placeIn(list, n), n);
            if (barrier != null) {
                barrier.reported(n.pending.input.index, token);
            }
        }
    }

    /** By input event, then by arrival: the order in which a state is written and read, so that both strike in the same order. */
    private static int placeIn(List<NamedToken> list, NamedToken n) {
        int at = list.size();
        while (at > 0 && list.get(at - 1).pending.input.index > n.pending.input.index) {
            at--;
        }
        return at;
    }

    private void unindex(NamedToken n) {
        for (Token token : n.tokens) {
            List<NamedToken> list = index.get(token);
            if (list.size() == 1) {
                index.remove(token);
            } else {
                list.remove(n);
            }
            if (barrier != null) {
                barrier.withdrawn(n.pending.input.index, token);
            }
        }
    }
}
