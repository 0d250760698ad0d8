package org.sami.petri.pnml;

/**
 * How large a file may be that is read.
 *
 * @param bytes of the file
 * @param nodes places and transitions together, also those that a coloured net unfolds to
 * @param arcs arcs of all kinds
 * @param depth how deep elements may be nested
 * @param text the length of a name, an id or a number, in characters
 */
public record PnmlLimits(long bytes, int nodes, int arcs, int depth, int text) {
    /** For files of strangers: 256 MiB, two million nodes, eight million arcs. */
    public static final PnmlLimits STANDARD = new PnmlLimits(256L << 20, 2_000_000, 8_000_000, 512, 10_000);
}
