package org.sami.session.server;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.SecureRandom;
import java.util.Base64;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import org.sami.session.person.Person;

/**
 * What fronts show to fetch pictures and logs over HTTP: a random text for each login, which counts for as long as its WebSocket is open. Safe for use by several threads.
 */
final class Tickets {
    private static final int BYTES = 18;

    private final SecureRandom random = new SecureRandom();
    private final Map<Front, String> issued = new HashMap<>();

    /** A ticket for a front that has logged in; always the same for one. */
    synchronized String issue(Front front) {
        return issued.computeIfAbsent(front, one -> {
            byte[] bytes = new byte[BYTES];
            random.nextBytes(bytes);
            return Base64.getUrlEncoder().withoutPadding().encodeToString(bytes);
        });
    }

    /** The front has gone: its ticket counts no longer. */
    synchronized void revoke(Front front) {
        issued.remove(front);
    }

    /** The person whose front, which is still there, has this ticket; empty for a wrong one, for which it takes always the same time. */
    synchronized Optional<Person> person(String ticket) {
        byte[] given = ticket.getBytes(StandardCharsets.UTF_8);
        Optional<Person> person = Optional.empty();
        for (Map.Entry<Front, String> one : issued.entrySet()) {
            if (MessageDigest.isEqual(one.getValue().getBytes(StandardCharsets.UTF_8), given)) {
                person = one.getKey().person();
            }
        }
        return person;
    }
}
