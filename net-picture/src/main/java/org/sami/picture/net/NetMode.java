package org.sami.picture.net;

/** How much of a net is shown (thesis 5.1, Figure 5.2). */
public enum NetMode {
    /** All but the parts that were drawn in recovery mode. */
    NOMINAL("Nominal"),
    /**
     * The silhouettes of all vertices without words and lines; what is selected, and what it is connected to, in full.
     */
    RECOVERY("Recovery"),
    /** Everything. */
    ALL("All");

    private final String label;

    NetMode(String label) {
        this.label = label;
    }

    /** What people call it. */
    public String label() {
        return label;
    }

    /** The mode that comes next when one goes through all of them. */
    public NetMode next() {
        return switch (this) {
            case NOMINAL -> RECOVERY;
            case RECOVERY -> ALL;
            case ALL -> NOMINAL;
        };
    }
}
