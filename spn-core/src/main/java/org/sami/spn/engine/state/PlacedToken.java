package org.sami.spn.engine.state;

import org.jspecify.annotations.Nullable;
import org.sami.spn.protocol.Token;

/**
 * One token standing in one place: a knot in the place's list of its kind and in its visit's list. Copies of a token are
 * chained, oldest first.
 */
public final class PlacedToken {
    public static final int GENERIC = 0;
    public static final int PROXY = 1;
    public static final int TASK = 2;
    public static final int KINDS = 3;

    public final Token token;
    public final int kind;
    public final long order;
    public final PlaceState place;
    public final Visit visit;
    public @Nullable PlacedToken previousOfKind;
    public @Nullable PlacedToken nextOfKind;
    public @Nullable PlacedToken previousOfVisit;
    public @Nullable PlacedToken nextOfVisit;
    public @Nullable PlacedToken nextCopy;
    /** Number of the firing that removes it; marks need no clearing. */
    public long removedBy;
    /** Number of the last requirement that picked it as a returned token. */
    public long pickedBy;
    /** Number of the last edge that adds it. */
    public long addedBy;

    public PlacedToken(Token token, long order, PlaceState place, Visit visit) {
        this.token = token;
        this.kind = kindOf(token);
        this.order = order;
        this.place = place;
        this.visit = visit;
    }

    public static int kindOf(Token token) {
        if (token instanceof Token.Proxy) {
            return PROXY;
        }
        return token instanceof Token.Task ? TASK : GENERIC;
    }
}
