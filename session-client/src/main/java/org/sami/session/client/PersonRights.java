package org.sami.session.client;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.LinkedHashSet;
import java.util.Set;

/**
 * What a person may do in a session, as its server said at the login (docs/session-link.md, Login). Immutable.
 *
 * @param role such as {@code operator} or {@code observer}
 * @param rights of {@code stop}, {@code answer}, {@code press}, {@code start} and {@code drive}
 */
public record PersonRights(String role, Set<String> rights) {
    public PersonRights {
        rights = Set.copyOf(rights);
    }

    /** Reads a {@code welcome}; a server that names no rights gives none. */
    static PersonRights of(JsonNode welcome) {
        Set<String> rights = new LinkedHashSet<>();
        welcome.path("rights").forEach(right -> rights.add(right.asText()));
        return new PersonRights(welcome.path("role").asText("person without a role"), rights);
    }

    /** Whether the person has a right, by its name on the link. */
    public boolean has(String right) {
        return rights.contains(right);
    }
}
