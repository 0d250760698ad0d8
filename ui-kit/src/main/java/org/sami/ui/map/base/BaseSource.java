package org.sami.ui.map.base;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.sami.ui.geo.GeoBounds;
import org.sami.ui.geo.MapFrame;

/** A base map that was read. Its pictures are asked for by threads that nobody waits for, never the event thread; the rest by any. */
public interface BaseSource extends AutoCloseable {
    /** What people call it, in few letters. */
    String name();

    /** Whom to name for the map, in few letters; empty text where nobody is to be named. */
    String attribution();

    /** The box that it covers; none where it does not say. */
    Optional<GeoBounds> bounds();

    /** Whether it hides what lies below it. */
    boolean isImagery();

    /** What of the file is not shown, in one line that names file and number; empty where all is. */
    Optional<String> restriction();

    /**
     * The scale of the tiles that show best.
     *
     * @param worldPx how many pixels of the screen the world is wide
     * @return how many pixels of its tiles the world is wide: less where it has no finer ones
     */
    double tileScale(double worldPx);

    /** The scale at which to look where a tile of this scale is not there; none where there is no coarser one. */
    OptionalDouble coarser(double tileScale);

    /**
     * The picture of a tile. Ends when its thread is interrupted.
     *
     * @return none where nothing is there
     */
    Optional<BufferedImage> tile(TileKey key, BaseStyle style) throws IOException;

    /** Points with names in a part of the map, so many at most; none where there are more, or where it has none. */
    List<NamedPoint> names(MapFrame frame, int most);

    @Override
    void close() throws IOException;
}
