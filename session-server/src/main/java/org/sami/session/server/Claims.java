package org.sami.session.server;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.session.api.RefusedException;

/** Who drives which boat by hand. For one thread. */
final class Claims {
    private final Map<String, Front> holders = new HashMap<>();

    /** Claims a boat for a person; refused while another connection has it. */
    void claim(String boat, Front front) {
        Front holder = holders.get(boat);
        if (holder != null && holder != front) {
            throw new RefusedException(holder.name() + " drives " + boat + " by hand"
                    + (holder.name().equals(front.name()) ? " on another screen" : ""));
        }
        holders.put(boat, front);
    }

    /** Refuses what only the holder may do. */
    void check(String boat, Front front) {
        if (holders.get(boat) != front) {
            String who = Optional.ofNullable(holders.get(boat)).map(Front::name).orElse("nobody");
            throw new RefusedException("claim " + boat + " first: " + who + " drives it by hand");
        }
    }

    void release(String boat) {
        holders.remove(boat);
    }

    /** The boats of a connection. */
    List<String> of(Front front) {
        return holders.entrySet().stream()
                .filter(entry -> entry.getValue() == front)
                .map(Map.Entry::getKey)
                .sorted()
                .toList();
    }

    /** Who has which boat. */
    Map<String, String> drivers() {
        Map<String, String> names = new HashMap<>();
        holders.forEach((boat, front) -> names.put(boat, front.name()));
        return names;
    }
}
