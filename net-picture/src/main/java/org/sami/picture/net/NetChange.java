package org.sami.picture.net;

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

    /** The sign next to it, so that nobody depends on colours. */
    public String sign() {
        return sign;
    }
}
