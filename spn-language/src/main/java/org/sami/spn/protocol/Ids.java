package org.sami.spn.protocol;

/** Conventions of the ids in this package. */
public final class Ids {
    /** No mission, no activation. */
    public static final long NONE = 0;

    private Ids() {}
}
