package org.sami.spn.value;

import java.util.Objects;

/** The identity of one robot's proxy (thesis 3.1, Tokens). */
public record ProxyValue(String proxy) implements Value {
    public ProxyValue {
        Objects.requireNonNull(proxy, "proxy");
    }
}
