package org.sami.spn.engine.state;

import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Token;

/**
 * Something that is due at a time: a timer activation, for a token or for nobody, or a decision's deadline. It names by their
 * ids what it runs for, which cancels it when it ends.
 *
 * @param activation whose timer it is; {@link Ids#NONE} for a deadline
 * @param token whose timer it is; generic for nobody, and for a deadline
 * @param decision whose deadline it is; {@link Ids#NONE} for the timer of an activation
 */
public record RunningTimer(long due, long id, long activation, Token token, long decision)
        implements Comparable<RunningTimer> {
    public boolean isDeadline() {
        return decision != Ids.NONE;
    }

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
