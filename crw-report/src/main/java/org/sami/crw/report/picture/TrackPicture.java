package org.sami.crw.report.picture;

import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.Shape;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Point2D;
import java.io.IOException;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.stream.Stream;

/**
 * A picture of tracks alone, without a run: lines with their starts and ends, and points, on the same map as
 * {@link MapPicture}'s. Drawn in memory; needs no display.
 */
public final class TrackPicture {
    private static final int WIDTH = 1480;
    private static final int HEIGHT = 1080;
    private static final Rectangle MAP = new Rectangle(64, 96, 1000, 916);
    private static final Rectangle LEGEND = new Rectangle(1096, 96, 352, 916);
    private static final int NAMED = 12;

    private final Text text;
    private final List<Track> tracks;
    private final List<Point2D> dots;

    /**
     * The text next to the map.
     *
     * @param title above the picture
     * @param subtitle below the title
     * @param axes what the numbers along the edges are
     * @param dots what the points are; shown where there are any
     * @param facts pairs for the panel, in their order
     */
    public record Text(String title, String subtitle, String axes, String dots, Map<String, String> facts) {
        public Text {
            Objects.requireNonNull(title, "title");
            Objects.requireNonNull(subtitle, "subtitle");
            Objects.requireNonNull(axes, "axes");
            Objects.requireNonNull(dots, "dots");
            Objects.requireNonNull(facts, "facts");
        }
    }

    /**
     * A line on the map.
     *
     * @param told the text next to its name
     * @param points metres east and north, at least one
     */
    public record Track(String name, String told, List<Point2D> points) {
        public Track {
            Objects.requireNonNull(name, "name");
            Objects.requireNonNull(told, "told");
            points = List.copyOf(points);
            if (points.isEmpty()) {
                throw new IllegalArgumentException("a track has a point");
            }
        }
    }

    /** A picture of at least one track; dots are in metres east and north, too. */
    public TrackPicture(Text text, List<Track> tracks, List<Point2D> dots) {
        this.text = Objects.requireNonNull(text, "text");
        this.tracks = List.copyOf(tracks);
        this.dots = List.copyOf(dots);
        if (this.tracks.isEmpty()) {
            throw new IllegalArgumentException("a picture has a track");
        }
    }

    /** The picture as a PNG file's content. */
    public byte[] png() throws IOException {
        return PngPicture.of(WIDTH, HEIGHT, this::draw);
    }

    private void draw(Graphics2D g) {
        g.setColor(MapColors.PAPER);
        g.fillRect(0, 0, WIDTH, HEIGHT);
        g.setColor(MapColors.INK);
        g.setFont(DrawnText.font(Font.BOLD, 26));
        g.drawString(text.title(), MAP.x, 44);
        g.setColor(MapColors.FAINT_INK);
        g.setFont(DrawnText.font(Font.PLAIN, 16));
        g.drawString(text.subtitle(), MAP.x, 74);
        Stream<Point2D> all = tracks.stream().flatMap(track -> track.points().stream());
        MapScale scale = MapScale.fitting(Stream.concat(all, dots.stream()), MAP);
        new WaterDrawing(MAP, scale, text.axes()).draw(g);
        Shape before = g.getClip();
        g.clip(MAP);
        map(g, scale);
        g.setClip(before);
        legend(g);
    }

    private void map(Graphics2D g, MapScale scale) {
        for (int i = 0; i < tracks.size(); i++) {
            line(g, scale, i);
        }
        dots.forEach(dot -> dot(g, scale.at(dot.getX(), dot.getY())));
        for (int i = 0; i < tracks.size(); i++) {
            List<Point2D> points = tracks.get(i).points();
            Point2D last = points.get(points.size() - 1);
            MapSymbols.start(g, scale.at(points.get(0).getX(), points.get(0).getY()), MapColors.color(i));
            MapSymbols.boat(g, scale.at(last.getX(), last.getY()), bearing(points), MapColors.color(i));
        }
    }

    private void line(Graphics2D g, MapScale scale, int track) {
        Path2D way = new Path2D.Double();
        for (Point2D point : tracks.get(track).points()) {
            Point2D at = scale.at(point.getX(), point.getY());
            if (way.getCurrentPoint() == null) {
                way.moveTo(at.getX(), at.getY());
            } else {
                way.lineTo(at.getX(), at.getY());
            }
        }
        MapColors.track(g, way, track);
    }

    private static void dot(Graphics2D g, Point2D at) {
        Shape disc = new Ellipse2D.Double(at.getX() - 4, at.getY() - 4, 8, 8);
        g.setColor(new Color(255, 255, 255, 200));
        g.fill(disc);
        g.setColor(MapColors.INK);
        g.setStroke(MapColors.dashed(1.2f));
        g.draw(disc);
    }

    /** The way of the last metre or more, clockwise from north, in radians. */
    private static double bearing(List<Point2D> points) {
        Point2D last = points.get(points.size() - 1);
        for (int i = points.size() - 2; i >= 0; i--) {
            if (points.get(i).distance(last) > 1) {
                return Math.atan2(
                        last.getX() - points.get(i).getX(),
                        last.getY() - points.get(i).getY());
            }
        }
        return 0;
    }

    private void legend(Graphics2D g) {
        int y = heading(g, "Track", LEGEND.y + 18);
        for (int i = 0; i < Math.min(NAMED, tracks.size()); i++) {
            MapColors.track(g, new Line2D.Double(LEGEND.x + 2, y - 5, LEGEND.x + 54, y - 5), i);
            said(g, Font.BOLD, tracks.get(i).name(), LEGEND.x + 68, y);
            said(g, Font.PLAIN, tracks.get(i).told(), LEGEND.x + 68, y + 18);
            y += 42;
        }
        if (tracks.size() > NAMED) {
            said(g, Font.ITALIC, "and " + (tracks.size() - NAMED) + " more", LEGEND.x + 68, y);
            y += 24;
        }
        y = heading(g, "Signs", y + 22);
        MapSymbols.start(g, new Point2D.Double(LEGEND.x + 20.0, y - 5.0), MapColors.color(0));
        said(g, Font.PLAIN, "start", LEGEND.x + 48, y);
        y += 36;
        MapSymbols.boat(g, new Point2D.Double(LEGEND.x + 20.0, y - 5.0), 0, MapColors.color(0));
        said(g, Font.PLAIN, "end", LEGEND.x + 48, y);
        y += 36;
        if (!dots.isEmpty()) {
            dot(g, new Point2D.Double(LEGEND.x + 20.0, y - 5.0));
            said(g, Font.PLAIN, text.dots(), LEGEND.x + 48, y);
            y += 36;
        }
        y = heading(g, "Log", y + 22);
        for (Map.Entry<String, String> fact : text.facts().entrySet()) {
            g.setColor(MapColors.FAINT_INK);
            g.setFont(DrawnText.font(Font.PLAIN, 15));
            g.drawString(fact.getKey(), LEGEND.x, y);
            said(g, Font.PLAIN, fact.getValue(), LEGEND.x + 148, y);
            y += 25;
        }
    }

    private static int heading(Graphics2D g, String heading, int y) {
        g.setColor(MapColors.INK);
        g.setFont(DrawnText.font(Font.BOLD, 19));
        g.drawString(heading, LEGEND.x, y);
        g.setColor(MapColors.GRID);
        g.setStroke(MapColors.dashed(1.5f));
        g.draw(new Line2D.Double(LEGEND.x, y + 8, LEGEND.getMaxX(), y + 8));
        return y + 34;
    }

    private static void said(Graphics2D g, int style, String words, int x, int y) {
        g.setColor(MapColors.INK);
        g.setFont(DrawnText.font(style, 15));
        g.drawString(words, x, y);
    }
}
