package org.sami.spn.plannet;

import java.util.Objects;

/**
 * What a firing does with one token.
 *
 * @param from the place that it leaves; empty where it is made, or stays where it is
 * @param to the place that it enters; empty where it is consumed
 */
public record PlanNetMove(String token, String from, String to) {
    public PlanNetMove {
        Objects.requireNonNull(token, "token");
        Objects.requireNonNull(from, "from");
        Objects.requireNonNull(to, "to");
    }
}
