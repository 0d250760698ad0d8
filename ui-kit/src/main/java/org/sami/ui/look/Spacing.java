package org.sami.ui.look;

/** Distances and sizes in logical pixels, for MigLayout as they are and for painting through {@link Look#px}. Steps of four. */
public final class Spacing {
    /** Between things that belong together. */
    public static final int TIGHT = 4;
    /** Between neighbours; the default. */
    public static final int NORMAL = 8;
    /** Around a panel's content. */
    public static final int INSET = 12;
    /** Between groups. */
    public static final int WIDE = 16;
    /** The least height and width of what is clicked, in an editor. */
    public static final int HIT_TARGET = 32;
    /** The least height and width of what is clicked in the field, with wet hands. */
    public static final int HIT_TARGET_FIELD = 40;

    private Spacing() {}
}
