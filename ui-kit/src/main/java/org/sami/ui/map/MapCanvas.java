package org.sami.ui.map;

import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.GraphicsDevice;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.geom.Point2D;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.jxmapviewer.JXMapViewer;
import org.sami.palette.SemanticColor;
import org.sami.palette.Theme;
import org.sami.spn.value.GeoPoint;
import org.sami.ui.geo.GeoBounds;
import org.sami.ui.geo.MapFrame;
import org.sami.ui.geo.Mercator;
import org.sami.ui.look.FocusFrame;
import org.sami.ui.look.Fonts;
import org.sami.ui.look.Look;

/** The map itself, without what stands around it: base map, grid, layers, tool, scale. */
final class MapCanvas extends JXMapViewer {
    private static final int MARGIN_PX = 48;
    private static final int SMALL = 8; // a margin is at most this part of a small map
    private static final double MOST_MAGNIFIED = 1.999;
    private static final int SCALE_WIDE = 150;
    private static final int SCALE_HIGH = 44;
    private static final double POINT_ALONE_M = 60; // what is shown around one point

    private final transient MapLayers layers = new MapLayers(this::repaint);
    private final transient MapScale scale = new MapScale();
    private final transient MapMessage message = new MapMessage();
    private final transient StillImage still = new StillImage();
    private final transient StillImage whole = new StillImage();
    private transient MapTool tool = new MapTool() {};
    private transient Set<String> highlighted = Set.of();
    private transient Optional<GeoBounds> toFit = Optional.empty();
    private final transient MapLabels labels = new MapLabels();
    private transient Optional<GeoBounds> fitted = Optional.empty();
    private transient @Nullable MapFrame fittedAt;
    private boolean grid = true;
    private boolean inForm;
    private double magnification = 1; // of the zoom, less than 2

    MapCanvas() {
        setName("map-canvas");
        setFocusable(true);
        FocusFrame.watch(this);
        setRestrictOutsidePanning(false);
        setHorizontalWrapped(false);
        setInfiniteMapRendering(false);
        setTileFactory(new NoTiles());
        setZoom(4);
        setOverlayPainter((g, map, width, height) -> paintLayers(g));
    }

    void setInForm(boolean inForm) {
        this.inForm = inForm;
    }

    boolean isInForm() {
        return inForm;
    }

    MapLayers layers() {
        return layers;
    }

    void setTool(MapTool tool) {
        this.tool = tool;
        setCursor(tool.cursor());
        repaint();
    }

    MapTool tool() {
        return tool;
    }

    void highlight(Set<String> ids) {
        highlighted = Set.copyOf(ids);
        repaint();
    }

    /** Says one line on the map; a problem in the colour of one, empty text nothing. */
    void say(String text, boolean problem) {
        message.say(text, problem);
        getAccessibleContext().setAccessibleDescription(text);
        repaint();
    }

    /** The lines of text on the map. */
    String said() {
        return message.text();
    }

    void setGrid(boolean shown) {
        grid = shown;
        repaint();
    }

    boolean hasGrid() {
        return grid;
    }

    /** Which part of the world is shown. */
    MapFrame frame() {
        double world = worldPx(getZoom());
        Point2D centre = getCenter();
        return new MapFrame(
                centre.getX() / world, centre.getY() / world, world * magnification, getWidth(), getHeight());
    }

    private static double worldPx(int zoom) {
        return Math.scalb((double) NoTiles.TILE_PX, NoTiles.FINEST_LEVEL - zoom);
    }

    private void centre(double x, double y) {
        double world = worldPx(getZoom());
        setCenter(new Point2D.Double(x * world, y * world));
        repaint();
    }

    /** Moves what is shown by some pixels. */
    void pan(double dx, double dy) {
        MapFrame frame = frame();
        centre(frame.centreX() + dx / frame.worldPx(), frame.centreY() + dy / frame.worldPx());
    }

    /** Shows a point in the middle. */
    void centre(GeoPoint point) {
        centre(Mercator.x(point.lonDeg()), Mercator.y(point.latDeg()));
    }

    /** Zooms by steps of two, nearer where they are positive; the point at a pixel stays there. */
    void zoom(int steps, double px, double py) {
        MapFrame before = frame();
        int zoom = Math.max(0, Math.min(NoTiles.FARTHEST_ZOOM, getZoom() - steps));
        if (zoom == getZoom()) {
            return;
        }
        double x = before.centreX() + (px - getWidth() / 2.0) / before.worldPx();
        double y = before.centreY() + (py - getHeight() / 2.0) / before.worldPx();
        setZoom(zoom);
        double world = worldPx(zoom) * magnification;
        centre(x - (px - getWidth() / 2.0) / world, y - (py - getHeight() / 2.0) / world);
    }

    /** Shows a box as large as it fits; later, where the map has no size yet. */
    void fit(GeoBounds box) {
        if (getWidth() == 0 || getHeight() == 0) {
            toFit = Optional.of(box);
            return;
        }
        toFit = Optional.empty();
        fitted = Optional.of(box);
        double west = Mercator.x(box.westDeg());
        double east = Mercator.x(box.eastDeg());
        double north = Mercator.y(box.northDeg());
        double south = Mercator.y(box.southDeg());
        double alone = POINT_ALONE_M / Mercator.metresPerWorld((box.northDeg() + box.southDeg()) / 2);
        int across = 2 * Math.min(MARGIN_PX, getWidth() / SMALL);
        int down = 2 * Math.min(MARGIN_PX, getHeight() / SMALL);
        double wide = Math.max(east - west, alone);
        double high = Math.max(south - north, alone);
        int zoom = 0;
        while (zoom < NoTiles.FARTHEST_ZOOM
                && (wide * worldPx(zoom) > getWidth() - across || high * worldPx(zoom) > getHeight() - down)) {
            zoom++;
        }
        setZoom(zoom);
        double larger =
                Math.min((getWidth() - across) / (wide * worldPx(zoom)), (getHeight() - down) / (high * worldPx(zoom)));
        magnification = Math.max(1, Math.min(MOST_MAGNIFIED, larger));
        centre((west + east) / 2, (north + south) / 2);
        fittedAt = frame();
    }

    /** Whether nobody has moved the map since a box was fitted into it. */
    private boolean isFitted() {
        MapFrame now = frame();
        return fitted.isPresent()
                && fittedAt != null
                && now.worldPx() == fittedAt.worldPx()
                && now.centreX() == fittedAt.centreX()
                && now.centreY() == fittedAt.centreY();
    }

    /** What was fitted stays so while the map becomes larger or smaller, until somebody moves it. */
    @Override
    public void setBounds(int x, int y, int width, int height) {
        boolean again = (width != getWidth() || height != getHeight()) && getWidth() > 0 && isFitted();
        super.setBounds(x, y, width, height);
        (again ? fitted : toFit).ifPresent(this::fit);
    }

    /** Paints it in memory first: a screen draws many small shapes slowly, and copies one image quickly. */
    @Override
    protected void paintComponent(Graphics g) {
        Graphics2D target = (Graphics2D) g;
        if (target.getDeviceConfiguration().getDevice().getType() == GraphicsDevice.TYPE_IMAGE_BUFFER) {
            super.paintComponent(g);
        } else {
            whole.paint(target, new Object(), getWidth(), getHeight(), super::paintComponent);
        }
        FocusFrame.paint(g, this);
    }

    /** All that {@link #paintStill} depends on. */
    private record Still(
            MapFrame frame, boolean grid, Object layers, Set<String> highlighted, Theme theme, int percent) {}

    @Override
    protected void drawMapTiles(Graphics g, int zoom, Rectangle viewport) {
        Still now = new Still(frame(), grid, layers.stillRevision(), highlighted, Look.theme(), Look.scalePercent());
        still.paint((Graphics2D) g, now, getWidth(), getHeight(), this::paintStill);
    }

    private void paintStill(Graphics2D g) {
        g.setColor(SemanticColor.MAP_WATER.get());
        g.fillRect(0, 0, getWidth(), getHeight());
        MapPaint paint = paint(g);
        if (grid && !hasImagery()) {
            scale.paintGrid(paint);
        }
        layers.visible().forEach(layer -> layer.paintStill(paint));
    }

    private boolean hasImagery() {
        return layers.visible().stream()
                .anyMatch(layer ->
                        layer instanceof BaseLayer base && base.source().isImagery());
    }

    /** The box around all base maps that are shown. */
    Optional<GeoBounds> extent() {
        return layers.visible().stream()
                .flatMap(layer -> layer instanceof BaseLayer base ? base.extent().stream() : Stream.empty())
                .reduce(GeoBounds::with);
    }

    /** Whom to name for what is shown. */
    private String attribution() {
        return layers.visible().stream()
                .flatMap(layer -> layer instanceof BaseLayer base
                        ? Stream.of(base.source().attribution())
                        : Stream.empty())
                .filter(text -> !text.isEmpty())
                .distinct()
                .collect(Collectors.joining(" · "));
    }

    /** No name is written over the scale, or partly outside the map. */
    private void reserve() {
        int w = getWidth();
        int h = getHeight();
        labels.clear();
        labels.add(0, h - Look.px(SCALE_HIGH), Look.px(SCALE_WIDE), Look.px(SCALE_HIGH));
        labels.add(-w, -h, w, 3.0 * h);
        labels.add(w, -h, w, 3.0 * h);
        labels.add(0, -h, w, h);
        labels.add(0, h, w, h);
    }

    private void paintLayers(Graphics2D graphics) {
        Graphics2D g = (Graphics2D) graphics.create();
        MapPaint paint = paint(g);
        List<MapLayer> shown = layers.visible();
        reserve();
        message.setFree(attribution().isEmpty());
        message.avoid(shown.stream()
                .flatMap(layer ->
                        layer instanceof VehicleLayer some ? some.boxes(paint.frame()).stream() : Stream.empty())
                .toList());
        message.reserve(paint);
        paint(paint, shown, tool);
        scale.paint(paint, attribution());
        message.paint(paint);
        g.dispose();
    }

    /** Names come last, and are not crossed by any line: those of the tool first, then those of the topmost layer. */
    static void paint(MapPaint paint, List<MapLayer> shown, MapTool tool) {
        shown.forEach(layer -> layer.paint(paint));
        tool.paint(paint);
        tool.paintNames(paint);
        for (int i = shown.size() - 1; i >= 0; i--) {
            shown.get(i).paintNames(paint);
        }
    }

    private MapPaint paint(Graphics2D g) {
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        g.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
        g.setFont(Fonts.small());
        return new MapPaint(g, frame(), highlighted, labels, hasImagery());
    }
}
