package org.sami.spn.engine;

import org.sami.spn.protocol.Token;

/**
 * One token standing in one place: a knot in the place's list of its kind and in its visit's list. Copies of a token are
 * chained, oldest first.
 */
final class Entry {
    static final int GENERIC = 0;
    static final int PROXY = 1;
    static final int TASK = 2;
    static final int KINDS = 3;

    final Token token;
    final int kind;
    final long order;
    final PlaceState place;
    final Visit visit;
    Entry previousOfKind;
    Entry nextOfKind;
    Entry previousOfVisit;
    Entry nextOfVisit;
    Entry nextCopy;
    /** Number of the firing that removes it; marks need no clearing. */
    long removedBy;
    /** Number of the last requirement that picked it as a returned token. */
    long pickedBy;
    /** Number of the last edge that adds it. */
    long addedBy;

    Entry(Token token, long order, PlaceState place, Visit visit) {
        this.token = token;
        this.kind = kindOf(token);
        this.order = order;
        this.place = place;
        this.visit = visit;
    }

    static int kindOf(Token token) {
        if (token instanceof Token.Proxy) {
            return PROXY;
        }
        return token instanceof Token.Task ? TASK : GENERIC;
    }
}
