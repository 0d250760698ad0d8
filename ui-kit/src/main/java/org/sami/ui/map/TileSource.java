package org.sami.ui.map;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.util.Optional;
import org.sami.ui.geo.GeoBounds;

/** Where the tiles of a base map come from. It is asked by one thread that nobody waits for. */
public interface TileSource extends AutoCloseable {
    /** What people call it. */
    String name();

    /** Whom to name for the map; empty text where nobody is to be named. */
    String attribution();

    /** The box that it says it covers; none where it does not say. */
    Optional<GeoBounds> bounds();

    /** The finest level of which it has tiles: at level n the world is 2^n tiles wide. */
    int finestLevel();

    /**
     * A tile of 256 by 256 pixels. A source that may be slow ends when its thread is interrupted.
     *
     * @param x from the west, 0 first
     * @param y from the north, 0 first
     * @return none where the source has no such tile
     */
    Optional<BufferedImage> tile(int level, int x, int y) throws IOException;

    @Override
    void close() throws IOException;
}
