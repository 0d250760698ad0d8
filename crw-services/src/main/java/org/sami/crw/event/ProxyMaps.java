package org.sami.crw.event;

import java.util.LinkedHashMap;
import java.util.Map;
import org.sami.spn.value.MapValue;
import org.sami.spn.value.ProxyValue;
import org.sami.spn.value.Value;

/** Maps from boats to something, as the events Proxy Execute Path and Proxy Goto Point carry them (appendix .2.1). */
public final class ProxyMaps {
    private ProxyMaps() {}

    /** A map by the boats' ids as a value, in the same order. */
    public static MapValue toValue(Map<String, ? extends Value> byBoat) {
        Map<Value, Value> entries = new LinkedHashMap<>();
        byBoat.forEach((boat, value) -> entries.put(new ProxyValue(boat), value));
        return new MapValue(entries);
    }

    /**
     * A value as a map by the boats' ids, in the same order.
     *
     * @throws IllegalArgumentException where it is no such map
     */
    public static <T extends Value> Map<String, T> read(Value value, Class<T> type) {
        if (!(value instanceof MapValue map)) {
            throw new IllegalArgumentException("Not a map by boat: " + value);
        }
        Map<String, T> byBoat = new LinkedHashMap<>();
        map.entries().forEach((key, item) -> {
            if (!(key instanceof ProxyValue proxy) || !type.isInstance(item)) {
                throw new IllegalArgumentException(
                        "Not a map from boats to " + type.getSimpleName() + ": it has " + key + " = " + item);
            }
            byBoat.put(proxy.proxy(), type.cast(item));
        });
        return byBoat;
    }
}
