package org.sami.spn.engine;

import java.util.Objects;

/**
 * An interrupt that the operator can press now.
 *
 * @param asksForProxies whether pressing it needs robots: named by the press or chosen afterwards
 */
public record InterruptButton(long mission, String name, boolean asksForProxies) {
    public InterruptButton {
        Objects.requireNonNull(name, "name");
    }
}
