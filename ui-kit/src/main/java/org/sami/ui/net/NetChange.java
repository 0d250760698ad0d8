package org.sami.ui.net;

/** How an element of a net differs from that of another version. */
public enum NetChange {
    /** It is new. */
    ADDED("+"),
    /** It is gone. */
    REMOVED("−"),
    /** It is there in both, and says something else. */
    CHANGED("~");

    private final String sign;

    NetChange(String sign) {
        this.sign = sign;
    }

    /** The sign that stands beside it, so that no one has to tell colours apart. */
    public String sign() {
        return sign;
    }
}
