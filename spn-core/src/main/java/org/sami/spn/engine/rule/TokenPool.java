package org.sami.spn.engine.rule;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;
import org.sami.spn.engine.net.Reach;
import org.sami.spn.engine.state.PlaceState;
import org.sami.spn.engine.state.PlacedToken;
import org.sami.spn.engine.state.Visit;
import org.sami.spn.protocol.Token;

/**
 * What a firing may speak of in one in place: tokens in order of entry, without those that running instances hold.
 *
 * <p>Implements R-OUT-2, R-INT-5, R-SUB-2, R-SHR-6.
 */
public final class TokenPool {
    /** How many tokens of a kind the pool has. */
    public int count(PlaceState place, int kind, FiringScope scope) {
        if (scope.checked.isEmpty()) {
            if (scope.reach == Reach.ALL) {
                return place.count(kind);
            }
            if (scope.reach == Reach.FREE && place.shared.length == 0) {
                return place.count(kind) - place.held(kind);
            }
        }
        return count(place, kind, scope, t -> true);
    }

    /** How many tokens of a kind the pool has that fit. */
    public int count(PlaceState place, int kind, FiringScope scope, Predicate<Token> fits) {
        List<PlacedToken> returned = returned(place, scope);
        int n = 0;
        for (PlacedToken e = place.first(kind); e != null; e = place.nextOfKind(e)) {
            if (fits.test(e.token) && usable(e, scope, returned)) {
                n++;
            }
        }
        return n;
    }

    /** How many copies of a proxy or task token the pool has. */
    public int copies(PlaceState place, Token token, FiringScope scope) {
        List<PlacedToken> copies = place.copies(token);
        if (copies.isEmpty()) {
            return 0;
        }
        List<PlacedToken> returned = returned(place, scope);
        int n = 0;
        for (PlacedToken e : copies) {
            if (usable(e, scope, returned)) {
                n++;
            }
        }
        return n;
    }

    /** Adds the oldest tokens of a kind that fit, at most so many; says how many were added. */
    public int collect(
            PlaceState place,
            int kind,
            int limit,
            FiringScope scope,
            @Nullable Predicate<Token> fits,
            List<PlacedToken> into) {
        List<PlacedToken> returned = returned(place, scope);
        int n = 0;
        for (PlacedToken e = place.first(kind); e != null && n < limit; e = place.nextOfKind(e)) {
            if ((fits == null || fits.test(e.token)) && usable(e, scope, returned)) {
                into.add(e);
                n++;
            }
        }
        return n;
    }

    /** Adds the oldest tokens of any kind, at most so many; says how many were added. */
    public int collectAny(PlaceState place, int limit, FiringScope scope, List<PlacedToken> into) {
        int kinds = 0;
        int only = 0;
        for (int k = 0; k < PlacedToken.KINDS; k++) {
            if (place.count(k) > 0) {
                kinds++;
                only = k;
            }
        }
        if (kinds <= 1) {
            return collect(place, only, limit, scope, null, into);
        }
        List<PlacedToken> returned = returned(place, scope);
        int n = 0;
        for (PlacedToken e : place.inOrder()) {
            if (n == limit) {
                break;
            }
            if (usable(e, scope, returned)) {
                into.add(e);
                n++;
            }
        }
        return n;
    }

    /** Adds every copy of a proxy or task token; says how many were added. */
    public int collectCopies(PlaceState place, Token token, FiringScope scope, List<PlacedToken> into) {
        List<PlacedToken> copies = place.copies(token);
        if (copies.isEmpty()) {
            return 0;
        }
        List<PlacedToken> returned = returned(place, scope);
        int n = 0;
        for (PlacedToken e : copies) {
            if (usable(e, scope, returned)) {
                into.add(e);
                n++;
            }
        }
        return n;
    }

    /**
     * The tokens of a place that the returns used by a firing brought back, in order of entry; null where no static instance
     * limits the firing. A token is free when every static instance on the place has brought it back.
     */
    public @Nullable List<PlacedToken> returned(PlaceState place, FiringScope scope) {
        return place.shared.length == 0 ? null : returned(place, scope, PairedReturns.in(place, scope));
    }

    /**
     * The same, where it is known which returns the firing uses.
     *
     * @param paired null where it must wait for some
     */
    @Nullable
    List<PlacedToken> returned(PlaceState place, FiringScope scope, @Nullable PairedReturns paired) {
        if (paired == null) {
            return List.of();
        }
        if (!paired.limit()) {
            return null;
        }
        // the oldest of those equal to what returned, one for one
        List<Token> left = new ArrayList<>(paired.tokens);
        List<PlacedToken> result = place.inOrder();
        result.removeIf(e -> !standsFree(e, scope) || !left.remove(e.token));
        return result;
    }

    private static boolean usable(PlacedToken e, FiringScope scope, @Nullable List<PlacedToken> returned) {
        return returned == null ? standsFree(e, scope) : returned.contains(e);
    }

    /** Whether no dynamic instance holds a token back, and no checked return binds the firing to another visit. */
    private static boolean standsFree(PlacedToken e, FiringScope scope) {
        Visit bound = scope.checked.isEmpty() ? null : scope.visitIn(e.place());
        if (bound != null && bound != e.visit) {
            return false;
        }
        return switch (scope.reach) {
            case FREE -> !e.visit.held;
            case ABORTED -> !e.visit.held || e.visit.leftByAborted();
            case ALL -> true;
        };
    }
}
