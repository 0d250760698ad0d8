package org.sami.spn.engine.state;

import org.sami.spn.protocol.Token;

/**
 * Names one token standing in one place: the visit by which it entered, and which of the tokens of that visit it is. Made when a rule asks for it; a state keeps
 * none but in crowded places ({@link PlaceState}). Stays valid as a name after the token has left.
 */
public final class PlacedToken {
    public static final int GENERIC = 0;
    public static final int PROXY = 1;
    public static final int TASK = 2;
    public static final int KINDS = 3;

    public final Token token;
    public final Visit visit;
    /** Its position among the tokens that entered by the visit. */
    final int index;

    PlacedToken(Visit visit, int index) {
        this.token = visit.entered.get(index);
        this.visit = visit;
        this.index = index;
    }

    public static int kindOf(Token token) {
        if (token instanceof Token.Proxy) {
            return PROXY;
        }
        return token instanceof Token.Task ? TASK : GENERIC;
    }

    public int kind() {
        return kindOf(token);
    }

    public PlaceState place() {
        return visit.place;
    }

    /** Numbers the entries of tokens in a session: what entered later has a greater number. */
    public long order() {
        return visit.orderOf(index);
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof PlacedToken e && e.visit == visit && e.index == index;
    }

    @Override
    public int hashCode() {
        return Long.hashCode(order());
    }
}
