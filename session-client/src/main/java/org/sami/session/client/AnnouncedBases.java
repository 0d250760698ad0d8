package org.sami.session.client;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.List;

/** Reads the bases that a trusted base names (docs/session-link.md, Bases). */
final class AnnouncedBases {
    private AnnouncedBases() {}

    /**
     * The addresses in rows; those that this front cannot use are left out.
     *
     * @param trust is told of their certificates
     */
    static List<SessionAddress> read(Iterable<JsonNode> rows, ServerTrust trust) {
        List<SessionAddress> named = new ArrayList<>();
        for (JsonNode row : rows) {
            try {
                SessionAddress one = SessionAddress.parse(row.path("id").asText());
                if (row.has("certificate")) {
                    trust.announce(one.authority(), row.path("certificate").asText());
                }
                named.add(one);
            } catch (IllegalArgumentException unfit) {
                // such as a base's own address on its machine, which is another machine here
            }
        }
        return named;
    }
}
