package org.sami.spn.engine.state;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;

/**
 * Values by their names, in the order in which the names came. A copy has the same map until one of both is changed: searches copy a state for each step that
 * they try, and few steps change any of these values.
 */
public final class SharedValues<V> {
    private Map<String, V> values = Map.of();
    /** Whether others may have the same map: then it is never changed, but replaced. */
    private boolean shared = true;

    /** Without a value. */
    SharedValues() {}

    /** An independent copy. */
    SharedValues<V> copy() {
        SharedValues<V> copy = new SharedValues<>();
        copy.values = values;
        shared = true;
        return copy;
    }

    /** The value of a name, null where it has none. */
    public @Nullable V get(String name) {
        return values.get(name);
    }

    /** Gives a name a value. */
    public void put(String name, V value) {
        own().put(name, value);
    }

    /** Gives names their values, in place of all that there were. */
    public void replace(Map<String, V> others) {
        values = new LinkedHashMap<>(others);
        shared = false;
    }

    /** Takes the values of names that fit away. */
    public void removeIf(Predicate<String> fits) {
        if (values.keySet().stream().anyMatch(fits)) {
            own().keySet().removeIf(fits);
        }
    }

    /** All values, as they are until the next change; not to be changed by others. */
    public Map<String, V> all() {
        return Collections.unmodifiableMap(values);
    }

    private Map<String, V> own() {
        if (shared) {
            values = new LinkedHashMap<>(values);
            shared = false;
        }
        return values;
    }
}
