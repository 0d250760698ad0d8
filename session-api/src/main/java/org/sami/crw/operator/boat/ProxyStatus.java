package org.sami.crw.operator.boat;

/** How a boat stands in a mission, by the markup Proxy Status (appendix .2.3); the worse comes later. */
public enum ProxyStatus {
    /** As it should: green. */
    NOMINAL,
    /** Not quite: yellow. */
    WARNING,
    /** Badly: red. */
    SEVERE
}
