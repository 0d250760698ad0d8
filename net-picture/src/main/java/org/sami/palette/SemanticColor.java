package org.sami.palette;

import java.awt.Color;

/**
 * Colours by what they mean, with their value in each theme. A status colour never stands alone: a word or a shape is next to it.
 *
 * <p>Values are light, dark, sun.
 */
public enum SemanticColor {
    /** What windows lie on. */
    BACKGROUND(0xEEF1F4, 0x171B20, 0xFFFFFF),
    /** What content lies on: panels, tables, fields. */
    SURFACE(0xFFFFFF, 0x20262D, 0xFFFFFF),
    /** A strip or group that is set off from the surface. */
    SURFACE_RAISED(0xF5F7F9, 0x2A323A, 0xF0F0F0),
    /** Text. */
    TEXT(0x16202A, 0xE8ECF0, 0x000000),
    /** Text of less weight: units, ages, explanations. */
    MUTED(0x55606C, 0xA7B2BD, 0x2B2B2B),
    /** Words of what cannot be used now. */
    DISABLED(0x6B7580, 0x8B96A1, 0x4A4A4A),
    /** Lines between areas; they carry no meaning. */
    BORDER(0xCBD2D9, 0x3A444E, 0x000000),
    /** What can be pressed, links, the focus. */
    ACCENT(0x0B5CAD, 0x62B0F5, 0x003A94),
    /** Text on {@link #ACCENT}. */
    ON_ACCENT(0xFFFFFF, 0x0C141C, 0xFFFFFF),
    /** Behind what is selected. */
    SELECTION(0xCFE3F8, 0x254A6B, 0x003A94),
    /** Text on {@link #SELECTION}. */
    ON_SELECTION(0x0E2238, 0xF2F7FC, 0xFFFFFF),
    /** All is well. */
    OK(0x0A6B37, 0x55C98F, 0x005519),
    /** Something wants attention soon. */
    WARNING(0x8A5200, 0xFFB650, 0x733600),
    /** Something is wrong and wants attention now. */
    CRITICAL(0xB8152A, 0xFF7B7B, 0x9A0010),
    /** Behind a word about something that wants attention. */
    WARNING_FILL(0xFFD37A, 0xFFB650, 0x733600),
    /** Text on {@link #WARNING_FILL}. */
    ON_WARNING(0x1F1500, 0x1F1500, 0xFFFFFF),
    /** Behind a word about something wrong, and the fleet stop. */
    CRITICAL_FILL(0xB8152A, 0xC7253A, 0x9A0010),
    /** Text on {@link #CRITICAL_FILL}. */
    ON_CRITICAL(0xFFFFFF, 0xFFFFFF, 0xFFFFFF),
    /** Values that are no longer fresh. */
    STALE(0x6B7580, 0x8B96A1, 0x4A4A4A),

    /** What a net is drawn on. */
    NET_CANVAS(0xFFFFFF, 0x1B2026, 0xFFFFFF),
    /** The inside of a place. */
    NET_PLACE_FILL(0xF5F8FB, 0x262E36, 0xFFFFFF),
    /** The line of a place. */
    NET_PLACE(0x3D4B59, 0xAEBBC7, 0x000000),
    /** The bar of a transition. */
    NET_TRANSITION(0x2A3540, 0xC9D3DC, 0x000000),
    /** The line of an edge. */
    NET_EDGE(0x5B6875, 0x94A1AE, 0x000000),
    /** The start place. */
    NET_START(0x0A7A3E, 0x55C98F, 0x005519),
    /** An end place. */
    NET_END(0xB8152A, 0xFF7B7B, 0x9A0010),
    /** Silhouettes of recovery parts. */
    NET_RECOVERY(0x8793A0, 0x6F7B87, 0x595959),
    /** A transition that fires. */
    NET_FIRING(0xC25E00, 0xFFC15C, 0x8A3A00),
    /** A place that holds tokens. */
    NET_ACTIVE(0x0B5CAD, 0x62B0F5, 0x003A94),

    /** Frames around parts of a net. */
    NET_FRAME_BLUE(0x4F86BC, 0x6FA8DC, 0x003A94),
    /** Frames, blue-green. */
    NET_FRAME_TEAL(0x34918A, 0x58BDB4, 0x005B55),
    /** Frames, violet. */
    NET_FRAME_VIOLET(0x7F6CBD, 0xA996E0, 0x4A2F95),
    /** Frames, pink. */
    NET_FRAME_PINK(0xB56A99, 0xDB92C0, 0x8A1F66),
    /** Frames, yellow-brown. */
    NET_FRAME_SAND(0x94803F, 0xC9B370, 0x5C4700),
    /** Frames, grey. */
    NET_FRAME_GREY(0x76818C, 0x97A3AF, 0x333333),

    /** What a map without a base map is drawn on. */
    MAP_WATER(0xE3EDF4, 0x16222C, 0xFFFFFF),
    /** Land of outlines. */
    MAP_LAND(0xECE7DA, 0x2B2C26, 0xEDEDED),
    /** Outlines of land and constructions. */
    MAP_OUTLINE(0x6F675A, 0xA39B8A, 0x3A3A3A),
    /** Lines of the grid. */
    MAP_GRID(0xC3D0DA, 0x2C3A46, 0x8C8C8C),
    /** Words on the map itself: scale, grid. */
    MAP_TEXT(0x33414E, 0xC6D1DB, 0x000000),
    /** Around marks and words, so that they are seen on any map. */
    MAP_HALO(0xFFFFFF, 0x0C1218, 0xFFFFFF),
    /** Areas of missions. */
    MAP_AREA(0x0B5CAD, 0x62B0F5, 0x003A94),
    /** Hatching of areas where no boat may go. */
    MAP_NO_GO(0xB8152A, 0xFF7B7B, 0x9A0010),
    /** The fence that nothing may leave. */
    MAP_FENCE(0x8A5200, 0xFFB650, 0x733600),
    /** What a question speaks of, and what is being drawn. */
    MAP_HIGHLIGHT(0xA3128F, 0xFF8AF0, 0x7A006B);

    private final Color light;
    private final Color dark;
    private final Color sun;

    SemanticColor(int light, int dark, int sun) {
        this.light = new Color(light);
        this.dark = new Color(dark);
        this.sun = new Color(sun);
    }

    /** The value in the theme in force. */
    public Color get() {
        return in(Theme.inForce());
    }

    /**
     * The value in a theme, mixed with another.
     *
     * @param part of this colour, 0 to 1
     */
    public Color over(SemanticColor other, double part, Theme theme) {
        Color top = in(theme);
        Color below = other.in(theme);
        return new Color(
                mixed(top.getRed(), below.getRed(), part),
                mixed(top.getGreen(), below.getGreen(), part),
                mixed(top.getBlue(), below.getBlue(), part));
    }

    private static int mixed(int top, int below, double part) {
        return (int) Math.round(part * top + (1 - part) * below);
    }

    /** The value in the theme in force, as transparent as said: 0 to 255. */
    public Color withAlpha(int alpha) {
        return withAlpha(alpha, Theme.inForce());
    }

    /** The value in a theme, as transparent as said: 0 to 255. */
    public Color withAlpha(int alpha, Theme theme) {
        Color color = in(theme);
        return new Color(color.getRed(), color.getGreen(), color.getBlue(), alpha);
    }

    /** The value in a theme. */
    public Color in(Theme theme) {
        return switch (theme) {
            case LIGHT -> light;
            case DARK -> dark;
            case SUN -> sun;
        };
    }
}
