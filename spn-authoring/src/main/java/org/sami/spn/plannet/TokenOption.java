package org.sami.spn.plannet;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;

/** What a case of a firing supposes of one token, and does with it. Filled by {@link TokenOptions}, then only read. */
final class TokenOption {
    final PlanToken token;
    final boolean isNamed;
    /** The in places in which it stands, as far as they are known. */
    final List<String> present;
    /** Whether it is known where it stands. */
    final boolean isKnown;
    /** Whether nothing is supposed of it, and nothing is done with it. */
    final boolean isAnywhere;
    /** All places in which it stands, where robots are counted by these; else empty. */
    final Optional<Set<String>> standing;
    /** The level at which requirements with numbers select it, by group; 0 where they do not. */
    final Map<String, Integer> levels = new TreeMap<>();

    /** Whether it is a task that is spoken of because the robot is named to which it is allocated: nothing is made for its own name. */
    boolean isNamedByRobot;
    /** Whether no requirement selects it, wherever it stands. */
    boolean isUnselected;
    /** Whether a sub-mission brought it back. */
    boolean isReturned;

    final CaseArcs arcs = new CaseArcs();
    final List<PlanNetMove> moves = new ArrayList<>();
    /** The out edges along which it goes. */
    final Set<Integer> edges = new TreeSet<>();
    /** The in places from which it is removed; of several copies some may stay there. */
    final Set<String> removed = new TreeSet<>();
    /** The in places that it leaves. */
    final Set<String> left = new TreeSet<>();

    TokenOption(PlanToken token, boolean isNamed, List<String> present, boolean isKnown) {
        this(token, isNamed, present, isKnown, false, Optional.empty());
    }

    private TokenOption(
            PlanToken token,
            boolean isNamed,
            List<String> present,
            boolean isKnown,
            boolean isAnywhere,
            Optional<Set<String>> standing) {
        this.token = token;
        this.isNamed = isNamed;
        this.present = present;
        this.isKnown = isKnown;
        this.isAnywhere = isAnywhere;
        this.standing = standing;
    }

    /** Not named, wherever it stands. */
    static TokenOption anywhere(PlanToken token, boolean isKnown) {
        return new TokenOption(token, false, List.of(), isKnown, true, Optional.empty());
    }

    /** In none of the in places, as far as these tell. */
    boolean isAbsent() {
        return !isAnywhere && present.isEmpty();
    }

    /** Whether nothing is done with it. */
    boolean isStill() {
        return left.isEmpty() && edges.isEmpty();
    }

    /** The same suppositions; effects are to be filled in. */
    TokenOption again() {
        TokenOption again = new TokenOption(token, isNamed, present, isKnown);
        again.isNamedByRobot = isNamedByRobot;
        again.levels.putAll(levels);
        again.arcs.join(arcs);
        return again;
    }

    /** The same with its effects, of a token that stands in just these places. */
    TokenOption standingIn(Set<String> places) {
        TokenOption same = new TokenOption(token, isNamed, present, isKnown, isAnywhere, Optional.of(places));
        same.isNamedByRobot = isNamedByRobot;
        same.levels.putAll(levels);
        same.arcs.join(arcs);
        same.moves.addAll(moves);
        same.edges.addAll(edges);
        same.removed.addAll(removed);
        same.left.addAll(left);
        return same;
    }

    /** Where it stands afterwards if it stood in these places. */
    Set<String> after(Set<String> before) {
        Set<String> after = new TreeSet<>(before);
        after.removeAll(left);
        moves.stream().map(PlanNetMove::to).filter(to -> !to.isEmpty()).forEach(after::add);
        return Set.copyOf(after);
    }
}
