package org.sami.ui.map.base;

/**
 * A tile of the world.
 *
 * @param worldPx how many pixels of tiles the world is wide
 * @param x from the west, 0 first
 * @param y from the north, 0 first
 */
public record TileKey(double worldPx, int x, int y) {
    /** How many pixels a tile is wide and high. */
    public static final int PX = 256;

    /** Its left edge on the unit square. */
    public double left() {
        return x * (double) PX / worldPx;
    }

    /** Its upper edge on the unit square. */
    public double top() {
        return y * (double) PX / worldPx;
    }

    /** Its width and height on the unit square. */
    public double side() {
        return PX / worldPx;
    }

    /** The tile of a coarser scale in which this one's middle lies. */
    public TileKey at(double coarser) {
        double ratio = coarser / worldPx;
        return new TileKey(coarser, (int) Math.floor((x + 0.5) * ratio), (int) Math.floor((y + 0.5) * ratio));
    }
}
