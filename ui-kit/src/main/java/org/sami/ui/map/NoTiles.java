package org.sami.ui.map;

import org.jxmapviewer.viewer.Tile;
import org.jxmapviewer.viewer.TileFactory;
import org.jxmapviewer.viewer.TileFactoryInfo;

/** What the map viewer asks for the sizes of its zooms; it has no tiles: base maps are layers. */
final class NoTiles extends TileFactory {
    /** The level of the nearest zoom, 0; one more and a map has more pixels than an int counts. */
    static final int FINEST_LEVEL = 22;

    static final int FARTHEST_ZOOM = 19;
    static final int TILE_PX = 256;

    NoTiles() {
        super(new TileFactoryInfo("none", 0, FARTHEST_ZOOM, FINEST_LEVEL, TILE_PX, true, true, "", "x", "y", "z"));
    }

    @Override
    public Tile getTile(int x, int y, int zoom) {
        return new Tile(x, y, zoom);
    }

    @Override
    protected void startLoading(Tile tile) {
        // there is nothing to load
    }

    @Override
    public void dispose() {
        // nothing is held
    }
}
