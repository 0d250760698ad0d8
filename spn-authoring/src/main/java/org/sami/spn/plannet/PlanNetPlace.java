package org.sami.spn.plannet;

import java.util.Objects;

/**
 * What a place of the net stands for.
 *
 * @param planPlace id of the plan's place, behind the ids of the places whose sub-missions have it, as {@code swap/go}; empty with {@link Role#CONTROL}
 * @param token a robot's name, {@code generic} or a task's name behind {@code #}; empty where the place speaks of no single token
 */
public record PlanNetPlace(Role role, String planPlace, String token) {
    /** What its tokens mean. */
    public enum Role {
        /** So many copies of one token of the plan stand in one of its places. */
        TOKEN,
        /** So many visits by nobody. */
        NOBODY,
        /** So many copies of one token stand in a place of a sub-mission that is followed, or came back from it. */
        CHILD_TOKEN,
        /** So many visits by nobody in a place of a sub-mission that is followed. */
        CHILD_NOBODY,
        /** A sum of others, by which requirements count. */
        COUNT,
        /** What the net needs to follow the engine's rules, such as that the mission runs. */
        CONTROL
    }

    public PlanNetPlace {
        Objects.requireNonNull(role, "role");
        Objects.requireNonNull(planPlace, "planPlace");
        Objects.requireNonNull(token, "token");
    }
}
