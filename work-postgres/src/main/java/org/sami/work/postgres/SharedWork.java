package org.sami.work.postgres;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Objects;

/**
 * Work that is to be divided: so many runs, numbered from 0 in the order in which they are begun.
 *
 * @param name of it in its schema
 * @param settings all that results depend on, by name, such as the program's version: who has others cannot join
 */
public record SharedWork(String name, int runs, Map<String, String> settings) {
    public SharedWork {
        Objects.requireNonNull(name, "name");
        settings = Collections.unmodifiableMap(new LinkedHashMap<>(settings));
        if (runs < 1) {
            throw new IllegalArgumentException("there is no run in it");
        }
    }
}
