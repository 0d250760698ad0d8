package org.sami.spn.reference;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.FollowedMarking;
import org.sami.spn.protocol.Token;
import org.sami.spn.protocol.TokenMove;

/** Holds the marking that a subject's effects tell against the one that it has. */
final class Following {
    private final FollowedMarking followed = new FollowedMarking();

    /** What one input's effects tell otherwise than the state after them is; empty where nothing. */
    Optional<String> difference(Subject subject, List<Effect> effects) {
        try {
            effects.forEach(followed);
        } catch (IllegalStateException e) {
            return Optional.of("  the effects contradict themselves: " + e.getMessage());
        }
        Map<Long, Map<String, List<Token>>> markings = new LinkedHashMap<>();
        Map<Long, Set<String>> byNobody = new LinkedHashMap<>();
        for (long mission : followed.missions()) {
            markings.put(mission, followed.marking(mission));
            byNobody.put(mission, new LinkedHashSet<>(followed.visitedByNobody(mission)));
        }
        if (!markings.equals(subject.markings())) {
            return Optional.of("  followed markings " + markings + "\n    where stand " + subject.markings());
        }
        if (!byNobody.equals(subject.visitedByNobody())) {
            return Optional.of(
                    "  followed visits by nobody " + byNobody + "\n    where are " + subject.visitedByNobody());
        }
        return movesDiffer(effects);
    }

    /** A firing's moves are what leaves and enters right after it; what a drop takes may follow at once. */
    private static Optional<String> movesDiffer(List<Effect> effects) {
        for (int i = 0; i < effects.size(); i++) {
            if (effects.get(i) instanceof Effect.Fired fired) {
                List<String> moved = moved(fired.moves());
                List<String> told = told(fired, effects.subList(i + 1, effects.size()), moved.size());
                if (!moved.equals(told)) {
                    return Optional.of("  firing " + fired.firing() + " moves " + moved + "\n    but told are " + told);
                }
            }
        }
        return Optional.empty();
    }

    private static List<String> moved(List<TokenMove> moves) {
        List<String> words = new ArrayList<>();
        for (TokenMove move : moves) {
            move.from().ifPresent(from -> words.add(move.token() + " leaves " + from));
            move.to().ifPresent(to -> words.add(move.token() + " enters " + to));
        }
        return words.stream().sorted(Comparator.naturalOrder()).toList();
    }

    private static List<String> told(Effect.Fired fired, List<Effect> following, int most) {
        List<String> words = new ArrayList<>();
        boolean entered = false;
        for (Effect effect : following) {
            if (words.size() >= most) {
                break;
            }
            if (effect instanceof Effect.Entered e && e.mission() == fired.mission()) {
                entered = true;
                e.tokens().forEach(token -> words.add(token + " enters " + e.place()));
            } else if (effect instanceof Effect.Left e && e.mission() == fired.mission() && !entered) {
                e.tokens().forEach(token -> words.add(token + " leaves " + e.place()));
            } else if (!(effect instanceof Effect.Noted)) {
                break;
            }
        }
        return words.stream().sorted(Comparator.naturalOrder()).toList();
    }
}
