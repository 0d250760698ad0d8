package org.sami.spn.protocol;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Set;
import java.util.function.Consumer;

/**
 * Follows the markings of all missions from effects alone, so that a listener to a session's effects need not query its engine. It
 * must hear every effect in order, from the first one on, or from {@code EngineView.markingAsEffects()} on where it begins in
 * the middle of a session. Effects that move no token change nothing.
 *
 * <p>Used by one thread at a time; what its answers contain is immutable and may be kept. Missions that have ended are
 * forgotten, halted ones stay until they are aborted.
 */
public final class FollowedMarking implements Consumer<Effect> {
    private record Mission(
            long id, long parent, String place, String plan, String name, Map<String, Map<Long, List<Token>>> visits) {}

    private final Map<Long, Mission> missions = new LinkedHashMap<>();

    /**
     * Takes the next effect.
     *
     * @throws IllegalStateException if it speaks of a mission, a visit or a token that the earlier ones did not tell of: effects
     *     were missed or came out of order
     */
    @Override
    public void accept(Effect effect) {
        if (effect instanceof Effect.MissionStarted e) {
            missions.put(
                    e.mission(),
                    new Mission(e.mission(), e.parent(), e.place(), e.plan(), e.name(), new LinkedHashMap<>()));
        } else if (effect instanceof Effect.Entered e) {
            mission(e.mission())
                    .visits()
                    .computeIfAbsent(e.place(), place -> new LinkedHashMap<>())
                    .put(e.visit(), new ArrayList<>(e.tokens()));
        } else if (effect instanceof Effect.Left e) {
            left(e);
        } else if (effect instanceof Effect.MissionEnded e && e.outcome() != Outcome.HALTED) {
            missions.remove(e.mission());
        }
    }

    private void left(Effect.Left e) {
        Map<Long, List<Token>> visits = mission(e.mission()).visits().getOrDefault(e.place(), Map.of());
        List<Token> tokens = visits.get(e.visit());
        if (tokens == null) {
            throw new IllegalStateException("No visit " + e.visit() + " of '" + e.place() + "' in mission "
                    + e.mission() + " was reported, but " + e.tokens() + " left it");
        }
        for (Token token : e.tokens()) {
            if (!tokens.remove(token)) {
                throw new IllegalStateException(token + " left visit " + e.visit() + " of '" + e.place()
                        + "' in mission " + e.mission() + ", where only " + tokens + " are known to be");
            }
        }
        if (tokens.isEmpty()) {
            visits.remove(e.visit());
        }
    }

    private Mission mission(long id) {
        Mission mission = missions.get(id);
        if (mission == null) {
            throw new IllegalStateException("The start of mission " + id + " was not reported");
        }
        return mission;
    }

    /** Missions and instances that have not ended, in order of creation. */
    public List<Long> missions() {
        return List.copyOf(missions.keySet());
    }

    /** Whether a mission has begun and not ended. */
    public boolean isKnown(long mission) {
        return missions.containsKey(mission);
    }

    private Optional<Mission> known(long mission) {
        return Optional.ofNullable(missions.get(mission));
    }

    /** The id of a mission's plan; empty text where the mission is not known. */
    public String plan(long mission) {
        return known(mission).map(Mission::plan).orElse("");
    }

    /** The name of a mission; empty text where it is not known. */
    public String name(long mission) {
        return known(mission).map(Mission::name).orElse("");
    }

    /** The mission whose place runs this one; empty for a root, and where it is not known. */
    public OptionalLong parent(long mission) {
        Mission known = missions.get(mission);
        return known == null || known.parent() == Ids.NONE ? OptionalLong.empty() : OptionalLong.of(known.parent());
    }

    /** The place of the parent that runs a mission; empty text for a root, and where it is not known. */
    public String parentPlace(long mission) {
        return known(mission).map(Mission::place).orElse("");
    }

    /** The instances that a mission runs now, in order of creation. */
    public List<Long> children(long mission) {
        return missions.values().stream()
                .filter(m -> mission != Ids.NONE && m.parent() == mission)
                .map(Mission::id)
                .toList();
    }

    /** The tokens of each marked place in order of entry, by place id; empty where the mission is not known. */
    public Map<String, List<Token>> marking(long mission) {
        Map<String, List<Token>> marking = new LinkedHashMap<>();
        visits(mission).forEach((place, visits) -> {
            List<Token> tokens = flat(visits.values());
            if (!tokens.isEmpty()) {
                marking.put(place, tokens);
            }
        });
        return Collections.unmodifiableMap(marking);
    }

    /** The tokens of one place in order of entry. */
    public List<Token> tokens(long mission, String place) {
        return flat(visits(mission).getOrDefault(place, Map.of()).values());
    }

    private Map<String, Map<Long, List<Token>>> visits(long mission) {
        return known(mission).map(Mission::visits).orElse(Map.of());
    }

    private static List<Token> flat(Collection<List<Token>> visits) {
        return visits.stream().flatMap(List::stream).toList();
    }

    /** Places that nobody's visit keeps awake, marked or not: one was entered by nobody and that visit has not ended. */
    public Set<String> visitedByNobody(long mission) {
        Set<String> places = new LinkedHashSet<>();
        visits(mission).forEach((place, visits) -> {
            if (visits.containsValue(List.of())) {
                places.add(place);
            }
        });
        return Collections.unmodifiableSet(places);
    }
}
