package org.sami.spn.engine.state;

import java.util.ArrayList;
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
    public final MissionState mission;
    public final CompiledPlace place;
    public final int[] count = new int[PlacedToken.KINDS];
    /** How many of them are held by running instances. */
    public final int[] held = new int[PlacedToken.KINDS];

    public final @Nullable PlacedToken[] first = new PlacedToken[PlacedToken.KINDS];
    private final @Nullable PlacedToken[] last = new PlacedToken[PlacedToken.KINDS];
    private final Map<Token, PlacedToken> named = new HashMap<>(4);
    /** Visits by nobody that have not ended. */
    public final List<Visit> nobody = new ArrayList<>(0);
    /** Visits with sub-mission instances that have not ended, by id; created when needed. */
    public @Nullable Map<Long, Visit> instanceVisits;
    /** Static instances, in the order of the place's specifications; empty where it has none. */
    public SharedRun[] shared = {};
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
        return count[0] + count[1] + count[2];
    }

    /** The oldest copy of a proxy or task token, or null. */
    public @Nullable PlacedToken find(Token token) {
        return named.get(token);
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
        count[k]++;
        if (e.visit.held) {
            held[k]++;
        }
        e.previousOfKind = last[k];
        if (last[k] == null) {
            first[k] = e;
        } else {
            last[k].nextOfKind = e;
        }
        last[k] = e;
        if (k != PlacedToken.GENERIC) {
            PlacedToken copy = named.putIfAbsent(e.token, e);
            while (copy != null) {
                if (copy.nextCopy == null) {
                    copy.nextCopy = e;
                    break;
                }
                copy = copy.nextCopy;
            }
        }
        e.visit.add(e);
    }

    public void remove(PlacedToken e) {
        int k = e.kind;
        count[k]--;
        if (e.visit.held) {
            held[k]--;
        }
        if (e.previousOfKind == null) {
            first[k] = e.nextOfKind;
        } else {
            e.previousOfKind.nextOfKind = e.nextOfKind;
        }
        if (e.nextOfKind == null) {
            last[k] = e.previousOfKind;
        } else {
            e.nextOfKind.previousOfKind = e.previousOfKind;
        }
        if (k != PlacedToken.GENERIC) {
            removeNamed(e);
        }
        e.visit.remove(e);
    }

    private void removeNamed(PlacedToken e) {
        PlacedToken copy = named.get(e.token);
        if (copy == e) {
            if (e.nextCopy == null) {
                named.remove(e.token);
            } else {
                named.put(e.token, e.nextCopy);
            }
            return;
        }
        while (copy != null && copy.nextCopy != e) {
            copy = copy.nextCopy;
        }
        Objects.requireNonNull(copy, "a token that stands here").nextCopy = e.nextCopy;
    }

    /** Tokens in order of entry. */
    public List<PlacedToken> inOrder() {
        List<PlacedToken> result = new ArrayList<>(total());
        @Nullable PlacedToken[] next = first.clone();
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
