package org.sami.spn.engine.state;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.sami.spn.engine.net.CompiledPlace;
import org.sami.spn.protocol.Token;

/**
 * The marking of one place: a multiset of tokens in order of entry. Counting a kind, finding a token, its removal and the
 * oldest of a kind take constant time.
 */
public final class PlaceState {
    /** Up to so many proxy and task tokens are found by looking through them: in most places no table is needed. */
    private static final int FEW = 16;

    public final MissionState mission;
    public final CompiledPlace place;
    /** How many tokens of each kind stand here, then how many of each kind running instances hold. */
    private final int[] counts = new int[2 * PlacedToken.KINDS];
    /** The oldest token of each kind, then the newest of each. */
    private final @Nullable PlacedToken[] ends = new PlacedToken[2 * PlacedToken.KINDS];
    /** The oldest copy of each proxy and task token; null as long as there are few, which are looked through. */
    private @Nullable Map<Token, PlacedToken> named;

    /** Visits by nobody that have not ended. */
    private List<Visit> nobody = List.of();
    /** Visits with sub-mission instances that have not ended, by id; created when needed. */
    public @Nullable Map<Long, Visit> instanceVisits;
    /** Static instances, in the order of the place's specifications; empty where it has none. */
    public SharedRun[] shared = SharedRun.NONE;
    /** The last ended visit of each token, where answers outlive visits. */
    public @Nullable Map<Token, Visit> lastVisits;

    public PlaceState(MissionState mission, CompiledPlace place) {
        this.mission = mission;
        this.place = place;
    }

    public boolean isVisited() {
        return total() > 0 || !nobody.isEmpty();
    }

    public int total() {
        return counts[0] + counts[1] + counts[2];
    }

    /** How many tokens of a kind stand here. */
    public int count(int kind) {
        return counts[kind];
    }

    /** How many of them are held by running instances. */
    public int held(int kind) {
        return counts[PlacedToken.KINDS + kind];
    }

    /** More of them are held, or fewer. */
    void hold(int kind, int more) {
        counts[PlacedToken.KINDS + kind] += more;
    }

    /** The oldest token of a kind, or null. */
    public @Nullable PlacedToken first(int kind) {
        return ends[kind];
    }

    /** Visits by nobody that have not ended; changes when one begins or ends. */
    public List<Visit> byNobody() {
        return nobody;
    }

    /** A visit by nobody began. */
    public void addByNobody(Visit visit) {
        if (nobody.isEmpty()) {
            nobody = new ArrayList<>(1);
        }
        nobody.add(visit);
    }

    /** A visit by nobody ended. */
    public void removeByNobody(Visit visit) {
        nobody.remove(visit);
    }

    /** The oldest copy of a proxy or task token, or null. */
    public @Nullable PlacedToken find(Token token) {
        if (named != null) {
            return named.get(token);
        }
        for (PlacedToken e = ends[PlacedToken.kindOf(token)]; e != null; e = e.nextOfKind) {
            if (e.token.equals(token)) {
                return e;
            }
        }
        return null;
    }

    public Map<Long, Visit> instanceVisits() {
        return instanceVisits == null ? Map.of() : instanceVisits;
    }

    public void addInstanceVisit(Visit visit) {
        if (instanceVisits == null) {
            instanceVisits = new LinkedHashMap<>();
        }
        instanceVisits.put(visit.id, visit);
    }

    public void removeInstanceVisit(Visit visit) {
        if (instanceVisits != null) {
            instanceVisits.remove(visit.id);
        }
    }

    public void add(PlacedToken e) {
        int k = e.kind;
        PlacedToken copy = k == PlacedToken.GENERIC ? null : find(e.token);
        counts[k]++;
        if (e.visit.held) {
            hold(k, 1);
        }
        int newest = PlacedToken.KINDS + k;
        PlacedToken last = ends[newest];
        e.previousOfKind = last;
        if (last == null) {
            ends[k] = e;
        } else {
            last.nextOfKind = e;
        }
        ends[newest] = e;
        while (copy != null && copy.nextCopy != null) {
            copy = copy.nextCopy;
        }
        if (copy != null) {
            copy.nextCopy = e;
        } else if (k != PlacedToken.GENERIC) {
            name(e);
        }
        e.visit.add(e);
    }

    private void name(PlacedToken e) {
        if (named != null) {
            named.put(e.token, e);
        } else if (counts[PlacedToken.PROXY] + counts[PlacedToken.TASK] > FEW) {
            Map<Token, PlacedToken> all = new HashMap<>();
            for (int k = PlacedToken.PROXY; k <= PlacedToken.TASK; k++) {
                for (PlacedToken one = ends[k]; one != null; one = one.nextOfKind) {
                    all.putIfAbsent(one.token, one);
                }
            }
            named = all;
        }
    }

    public void remove(PlacedToken e) {
        int k = e.kind;
        PlacedToken oldest = k == PlacedToken.GENERIC ? null : find(e.token);
        counts[k]--;
        if (e.visit.held) {
            hold(k, -1);
        }
        if (e.previousOfKind == null) {
            ends[k] = e.nextOfKind;
        } else {
            e.previousOfKind.nextOfKind = e.nextOfKind;
        }
        if (e.nextOfKind == null) {
            ends[PlacedToken.KINDS + k] = e.previousOfKind;
        } else {
            e.nextOfKind.previousOfKind = e.previousOfKind;
        }
        if (oldest != null) {
            removeCopy(e, oldest);
        }
        e.visit.remove(e);
    }

    private void removeCopy(PlacedToken e, PlacedToken oldest) {
        if (oldest != e) {
            PlacedToken copy = oldest;
            while (copy.nextCopy != e) {
                copy = Objects.requireNonNull(copy.nextCopy, "a token that stands here");
            }
            copy.nextCopy = e.nextCopy;
        } else if (named != null) {
            if (e.nextCopy == null) {
                named.remove(e.token);
            } else {
                named.put(e.token, e.nextCopy);
            }
        }
    }

    /** Tokens in order of entry. */
    public List<PlacedToken> inOrder() {
        List<PlacedToken> result = new ArrayList<>(total());
        @Nullable PlacedToken[] next = Arrays.copyOf(ends, PlacedToken.KINDS);
        for (int i = total(); i > 0; i--) {
            int oldest = -1;
            for (int k = 0; k < PlacedToken.KINDS; k++) {
                if (next[k] != null && (oldest < 0 || next[k].order < next[oldest].order)) {
                    oldest = k;
                }
            }
            result.add(next[oldest]);
            next[oldest] = next[oldest].nextOfKind;
        }
        return result;
    }
}
