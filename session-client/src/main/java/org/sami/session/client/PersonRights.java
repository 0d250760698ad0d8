package org.sami.session.client;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.LinkedHashSet;
import java.util.Set;

/**
 * What a person may do in a session, as its server said (docs/session-link.md, Login). Immutable.
 *
 * @param role such as {@code operator} or {@code observer}
 * @param rights of {@code stop}, {@code answer}, {@code press}, {@code start}, {@code drive} and {@code setup}
 */
public record PersonRights(String role, Set<String> rights) {
    public PersonRights {
        rights = Set.copyOf(rights);
    }

    /** Reads a {@code welcome} or {@code rights}; a server that names no rights gives none. */
    static PersonRights of(JsonNode message) {
        Set<String> rights = new LinkedHashSet<>();
        message.path("rights").forEach(right -> rights.add(right.asText()));
        return new PersonRights(message.path("role").asText("person without a role"), rights);
    }

    /** Whether the person has a right, by its name on the link. */
    public boolean has(String right) {
        return rights.contains(right);
    }
}
