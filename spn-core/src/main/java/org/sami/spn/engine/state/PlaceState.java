package org.sami.spn.engine.state;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.BiConsumer;
import org.jspecify.annotations.Nullable;
import org.sami.spn.engine.net.CompiledPlace;
import org.sami.spn.protocol.Token;

/**
 * The marking of one place: a multiset of tokens in order of entry. It is the visits that have tokens here, in order, and of each which of its tokens
 * have not left: so most places keep nothing for each token, and are copied quickly. Counting a kind takes constant time, and so do finding a token
 * and its removal in a crowded place, which has a table.
 */
public final class PlaceState {
    /** Where up to so many tokens stand, one is found by looking through them: in most places no table is needed. */
    static final int FEW = 16;

    public final MissionState mission;
    public final CompiledPlace place;
    private int generic;
    private int proxies;
    private int tasks;
    /** How many of each kind running instances hold; null where none ever did. */
    private int @Nullable [] held;

    private @Nullable Visit firstHere;
    private @Nullable Visit lastHere;
    /** The copies of each proxy and task token, oldest first; null until one is looked for where there are more than a few tokens of any kind. */
    private @Nullable Map<Token, List<PlacedToken>> named;

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
        return generic + proxies + tasks;
    }

    /** How many tokens of a kind stand here. */
    public int count(int kind) {
        return switch (kind) {
            case PlacedToken.GENERIC -> generic;
            case PlacedToken.PROXY -> proxies;
            default -> tasks;
        };
    }

    private void count(int kind, int more) {
        switch (kind) {
            case PlacedToken.GENERIC -> generic += more;
            case PlacedToken.PROXY -> proxies += more;
            default -> tasks += more;
        }
    }

    /** How many of them are held by running instances. */
    public int held(int kind) {
        return held == null ? 0 : held[kind];
    }

    /** More of them are held, or fewer. */
    void hold(int kind, int more) {
        if (held == null) {
            held = new int[PlacedToken.KINDS];
        }
        held[kind] += more;
    }

    /** The oldest token of a kind, or null. */
    public @Nullable PlacedToken first(int kind) {
        return count(kind) == 0 ? null : next(firstHere, 0, kind);
    }

    /** The next token of the kind of one that stands here, or null. */
    public @Nullable PlacedToken nextOfKind(PlacedToken e) {
        return next(e.visit, e.index + 1, e.kind());
    }

    private static @Nullable PlacedToken next(@Nullable Visit from, int index, int kind) {
        int start = index;
        for (Visit v = from; v != null; v = v.nextHere) {
            for (int i = v.nextStanding(start); i >= 0; i = v.nextStanding(i + 1)) {
                if (v.kindAt(i) == kind) {
                    return new PlacedToken(v, i);
                }
            }
            start = 0;
        }
        return null;
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

    /** Whether a proxy or task token stands here. */
    public boolean has(Token token) {
        if (isCrowded()) {
            return named().containsKey(token);
        }
        for (Visit v = firstHere; v != null; v = v.nextHere) {
            if (v.indexOf(token, 0) >= 0) {
                return true;
            }
        }
        return false;
    }

    /** The oldest copy of a proxy or task token, or null. */
    public @Nullable PlacedToken find(Token token) {
        List<PlacedToken> copies = copies(token);
        return copies.isEmpty() ? null : copies.get(0);
    }

    /** The copies of a proxy or task token, oldest first; they do not follow the place. */
    public List<PlacedToken> copies(Token token) {
        if (isCrowded()) {
            return named().getOrDefault(token, List.of());
        }
        List<PlacedToken> found = List.of();
        for (Visit v = firstHere; v != null; v = v.nextHere) {
            for (int i = v.indexOf(token, 0); i >= 0; i = v.indexOf(token, i + 1)) {
                found = with(found, new PlacedToken(v, i));
            }
        }
        return found;
    }

    private static List<PlacedToken> with(List<PlacedToken> copies, PlacedToken newest) {
        if (copies.isEmpty()) {
            return List.of(newest);
        }
        List<PlacedToken> more = new ArrayList<>(copies);
        more.add(newest);
        return more;
    }

    /** A table is kept until half as many tokens are left, so that one that comes and goes does not make it again each time. */
    private boolean isCrowded() {
        return named != null || total() > FEW;
    }

    private Map<Token, List<PlacedToken>> named() {
        if (named == null) {
            named = new HashMap<>();
            for (Visit v = firstHere; v != null; v = v.nextHere) {
                name(v, named);
            }
        }
        return named;
    }

    private static void name(Visit v, Map<Token, List<PlacedToken>> all) {
        for (int i = v.nextStanding(0); i >= 0; i = v.nextStanding(i + 1)) {
            if (v.kindAt(i) != PlacedToken.GENERIC) {
                PlacedToken e = new PlacedToken(v, i);
                all.put(e.token, with(all.getOrDefault(e.token, List.of()), e));
            }
        }
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

    /** The tokens of a visit stand here from now on, after all others. */
    void add(Visit v) {
        int first = v.nextStanding(0);
        if (first < 0) {
            return;
        }
        for (int i = first; i >= 0; i = v.nextStanding(i + 1)) {
            count(v.kindAt(i), 1);
            if (v.held) {
                hold(v.kindAt(i), 1);
            }
        }
        v.previousHere = lastHere;
        if (lastHere == null) {
            firstHere = v;
        } else {
            lastHere.nextHere = v;
        }
        lastHere = v;
        if (named != null) {
            name(v, named);
        }
    }

    /** One token leaves. */
    public void remove(PlacedToken e) {
        Visit v = e.visit;
        int kind = e.kind();
        v.leave(e.index);
        count(kind, -1);
        if (v.held) {
            hold(kind, -1);
        }
        if (v.hasLeft()) {
            unlink(v);
        }
        if (total() <= FEW / 2) {
            named = null;
        }
        if (named != null && kind != PlacedToken.GENERIC) {
            List<PlacedToken> copies = new ArrayList<>(named.getOrDefault(e.token, List.of()));
            copies.remove(e);
            if (copies.isEmpty()) {
                named.remove(e.token);
            } else {
                named.put(e.token, copies);
            }
        }
    }

    private void unlink(Visit v) {
        if (v.previousHere == null) {
            firstHere = v.nextHere;
        } else {
            v.previousHere.nextHere = v.nextHere;
        }
        if (v.nextHere == null) {
            lastHere = v.previousHere;
        } else {
            v.nextHere.previousHere = v.previousHere;
        }
        v.previousHere = null;
        v.nextHere = null;
    }

    /** Gives the tokens in order of entry, each with its visit. */
    public void forEach(BiConsumer<Token, Visit> standing) {
        for (Visit v = firstHere; v != null; v = v.nextHere) {
            for (int i = v.nextStanding(0); i >= 0; i = v.nextStanding(i + 1)) {
                standing.accept(v.entered.get(i), v);
            }
        }
    }

    /** Tokens in order of entry. */
    public List<PlacedToken> inOrder() {
        List<PlacedToken> result = new ArrayList<>(total());
        for (Visit v = firstHere; v != null; v = v.nextHere) {
            v.addStanding(result);
        }
        return result;
    }
}
