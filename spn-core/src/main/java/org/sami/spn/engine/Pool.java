package org.sami.spn.engine;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;
import org.sami.spn.protocol.Token;

/**
 * What a firing may speak of in one in place: tokens in order of entry, without those that running instances hold
 * (SEMANTICS, Requirements and Sub-missions).
 */
final class Pool {
    /** How far a firing reaches. */
    enum Reach {
        /** Not what instances hold; of a static place only what the oldest unused return brought back. */
        FREE,
        /** Also what aborted instances left behind. */
        ABORTED,
        /** Everything: interrupts, abort and complete. */
        ALL
    }

    /** How many tokens of a kind the pool has. */
    int count(PlaceState place, int kind, Reach reach) {
        if (reach == Reach.ALL) {
            return place.count[kind];
        }
        if (reach == Reach.FREE && place.shared.length == 0) {
            return place.count[kind] - place.held[kind];
        }
        return count(place, kind, reach, t -> true);
    }

    /** How many tokens of a kind the pool has that fit. */
    int count(PlaceState place, int kind, Reach reach, Predicate<Token> fits) {
        List<Entry> returned = limits(place, reach) ? returned(place) : null;
        int n = 0;
        for (Entry e = place.first[kind]; e != null; e = e.nextOfKind) {
            if (fits.test(e.token) && usable(e, reach, returned)) {
                n++;
            }
        }
        return n;
    }

    /** How many copies of a proxy or task token the pool has. */
    int copies(PlaceState place, Token token, Reach reach) {
        Entry e = place.find(token);
        if (e == null) {
            return 0;
        }
        List<Entry> returned = limits(place, reach) ? returned(place) : null;
        int n = 0;
        for (; e != null; e = e.nextCopy) {
            if (usable(e, reach, returned)) {
                n++;
            }
        }
        return n;
    }

    /** Adds the oldest tokens of a kind that fit, at most so many; says how many were added. */
    int collect(PlaceState place, int kind, int limit, Reach reach, Predicate<Token> fits, List<Entry> into) {
        List<Entry> returned = limits(place, reach) ? returned(place) : null;
        int n = 0;
        for (Entry e = place.first[kind]; e != null && n < limit; e = e.nextOfKind) {
            if ((fits == null || fits.test(e.token)) && usable(e, reach, returned)) {
                into.add(e);
                n++;
            }
        }
        return n;
    }

    /** Adds the oldest tokens of any kind, at most so many; says how many were added. */
    int collectAny(PlaceState place, int limit, Reach reach, List<Entry> into) {
        int kinds = 0;
        int only = 0;
        for (int k = 0; k < Entry.KINDS; k++) {
            if (place.count[k] > 0) {
                kinds++;
                only = k;
            }
        }
        if (kinds <= 1) {
            return collect(place, only, limit, reach, null, into);
        }
        List<Entry> returned = limits(place, reach) ? returned(place) : null;
        int n = 0;
        for (Entry e : place.inOrder()) {
            if (n == limit) {
                break;
            }
            if (usable(e, reach, returned)) {
                into.add(e);
                n++;
            }
        }
        return n;
    }

    /** Adds every copy of a proxy or task token; says how many were added. */
    int collectCopies(PlaceState place, Token token, Reach reach, List<Entry> into) {
        Entry e = place.find(token);
        if (e == null) {
            return 0;
        }
        List<Entry> returned = limits(place, reach) ? returned(place) : null;
        int n = 0;
        for (; e != null; e = e.nextCopy) {
            if (usable(e, reach, returned)) {
                into.add(e);
                n++;
            }
        }
        return n;
    }

    /** The parent's tokens that the oldest unused returns of static instances brought back: one copy for each. */
    List<Entry> returned(PlaceState place) {
        List<Entry> result = new ArrayList<>();
        for (SharedRun run : place.shared) {
            SharedRun.Return oldest = run.returns.peek();
            if (oldest != null) {
                for (Token token : oldest.tokens()) {
                    Entry e = Entry.kindOf(token) == Entry.GENERIC ? place.first[Entry.GENERIC] : place.find(token);
                    while (e != null && result.contains(e)) {
                        e = e.kind == Entry.GENERIC ? e.nextOfKind : e.nextCopy;
                    }
                    if (e != null) {
                        result.add(e);
                    }
                }
            }
        }
        return result;
    }

    /** Whether only what static instances brought back can be used. */
    private static boolean limits(PlaceState place, Reach reach) {
        if (place.shared.length == 0 || reach == Reach.ALL) {
            return false;
        }
        for (SharedRun run : place.shared) {
            if (reach == Reach.ABORTED && run.instance.status == Instance.Status.ABORTED) {
                return false;
            }
        }
        return true;
    }

    private static boolean usable(Entry e, Reach reach, List<Entry> returned) {
        if (reach == Reach.ALL) {
            return true;
        }
        if (returned != null && !returned.contains(e)) {
            return false;
        }
        return !e.visit.held || (reach == Reach.ABORTED && e.visit.hasAborted());
    }
}
