package org.sami.spn.engine.state;

import org.sami.spn.protocol.Token;

/** Something that is due at a time: a timer activation, for a token or for nobody, or a decision's deadline. */
public record RunningTimer(long due, long id, SentActivation sent, Token token, OpenDecision decision)
        implements Comparable<RunningTimer> {
    @Override
    public int compareTo(RunningTimer other) {
        int byDue = Long.compare(due, other.due);
        return byDue != 0 ? byDue : Long.compare(id, other.id);
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof RunningTimer t && t.id == id;
    }

    @Override
    public int hashCode() {
        return Long.hashCode(id);
    }
}
