package org.sami.spn.model;

import java.util.HashSet;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;

/**
 * A marking from which a mission is to start instead of its start place, to try a plan from the middle
 * ({@code Engine.startAt}).
 *
 * @param places in the order in which they are entered; each once
 */
public record StartMarking(List<Tokens> places) {
    public StartMarking {
        places = List.copyOf(places);
    }

    /**
     * What enters one place, as one visit: so many generic tokens, then one token a robot, then one a task. Without any the place is
     * entered by nobody.
     *
     * @param place id of a place that is no end place
     * @param tasks names of the plan's tasks
     */
    public record Tokens(String place, int generic, List<String> proxies, List<String> tasks) {
        public Tokens {
            Objects.requireNonNull(place, "place");
            if (generic < 0) {
                throw new IllegalArgumentException("A number of tokens is not negative: " + generic);
            }
            proxies = List.copyOf(proxies);
            tasks = List.copyOf(tasks);
        }
    }

    /** Why a plan cannot start so, in one sentence; empty where it can. */
    public Optional<String> wrong(Plan plan, Set<String> known) {
        Set<String> seen = new HashSet<>();
        for (Tokens at : places) {
            Optional<Place> place = plan.place(at.place());
            if (place.isEmpty()) {
                return Optional.of("The plan '" + plan.name() + "' has no place '" + at.place() + "'");
            }
            if (place.get().end()) {
                return Optional.of("'" + at.place() + "' is an end place: a mission that stands there is over");
            }
            if (!seen.add(at.place())) {
                return Optional.of("The place '" + at.place() + "' is named twice in the start marking");
            }
            Optional<String> wrong = wrong(at, plan, known);
            if (wrong.isPresent()) {
                return wrong;
            }
        }
        return places.isEmpty() ? Optional.of("The start marking names no place") : Optional.empty();
    }

    private static Optional<String> wrong(Tokens at, Plan plan, Set<String> known) {
        for (String proxy : at.proxies()) {
            if (!known.contains(proxy)) {
                return Optional.of("No robot '" + proxy + "' is known that could stand in '" + at.place() + "'");
            }
        }
        for (String task : at.tasks()) {
            if (plan.tasks().stream().noneMatch(t -> t.name().equals(task))) {
                return Optional.of("The plan '" + plan.name() + "' has no task '" + task + "' that could stand in '"
                        + at.place() + "'");
            }
        }
        return Optional.empty();
    }
}
