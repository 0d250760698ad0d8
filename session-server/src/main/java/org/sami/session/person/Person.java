package org.sami.session.person;

import java.util.List;
import java.util.Objects;
import java.util.regex.Pattern;
import org.sami.spn.protocol.Decision;

/**
 * Somebody who takes part in a session. Immutable.
 *
 * @param name names the person in messages and logs
 * @param decisions the types of decisions that are theirs; empty for those of the role
 * @param keyHash SHA-256 of the key in hexadecimal digits; empty text where no key is needed
 */
public record Person(String name, PersonRole role, List<String> decisions, String keyHash) {
    private static final Pattern NAME = Pattern.compile("[A-Za-z0-9_.-]{1,40}");

    public Person {
        if (!NAME.matcher(name).matches()) {
            throw new IllegalArgumentException("a name has 1 to 40 letters, digits, '-', '_' or '.'");
        }
        Objects.requireNonNull(role, "role");
        decisions = List.copyOf(decisions);
        Objects.requireNonNull(keyHash, "keyHash");
    }

    /** Whether the role gives a right. */
    public boolean may(Right right) {
        return role.rights().contains(right);
    }

    /** Whether a decision is theirs to answer. */
    public boolean mayAnswer(Decision decision) {
        return may(Right.ANSWER)
                && (decisions.isEmpty() ? role.answers(decision) : decisions.contains(decision.type()));
    }
}
