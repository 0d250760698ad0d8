package org.sami.ui.map;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.geom.Path2D;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.spn.value.GeoPoint;
import org.sami.ui.geo.GeoBounds;

/**
 * Tracks that fade: the older, the fainter. What a track has grown by since all of it was painted is painted over that image, until it is
 * much and all are painted again.
 */
public final class TrackLayer extends MapLayer {
    private static final int SHADES = 5;
    private static final int MOST_GROWN = 40; // points
    private static final BasicStroke STROKE = new BasicStroke(2, BasicStroke.CAP_BUTT, BasicStroke.JOIN_BEVEL);

    private final Map<String, Shown> tracks = new LinkedHashMap<>();

    /** A track, and the index of its last point when all were painted last; -1 where it was not there. */
    private record Shown(Track track, WorldLine line, int painted) {
        Shown whole() {
            return new Shown(track, line, line.size() - 1);
        }

        boolean hasGrown() {
            return painted >= 0 && painted < line.size() - 1;
        }
    }

    public TrackLayer(String id, String title) {
        super(id, title);
    }

    /** Shows these tracks instead of those before. What they have in common with those is not projected again. */
    public void show(List<Track> next) {
        Map<String, Shown> before = new LinkedHashMap<>(tracks);
        boolean anew = false;
        tracks.clear();
        for (Track track : next) {
            Optional<Shown> known = Optional.ofNullable(before.remove(track.id()));
            Optional<Shown> grown = known.flatMap(one -> grown(one, track));
            anew |= grown.isEmpty();
            tracks.put(
                    track.id(),
                    grown.orElseGet(() -> new Shown(
                            track,
                            known.map(one -> new WorldLine(track.points(), one.line()))
                                    .orElseGet(() -> new WorldLine(track.points())),
                            -1)));
        }
        if (anew || !before.isEmpty()) {
            stillChanged();
        } else {
            changed();
        }
    }

    /** A track that has been painted, and has grown by little; none where it is another one, or has grown by much. */
    private static Optional<Shown> grown(Shown before, Track track) {
        if (track.equals(before.track())) {
            return Optional.of(before);
        }
        List<GeoPoint> points = track.points();
        if (!track.mark().equals(before.track().mark()) || before.painted() < 0) {
            return Optional.empty();
        }
        GeoPoint last = before.line().points().get(before.painted());
        for (int i = points.size() - 1; i >= Math.max(0, points.size() - MOST_GROWN); i--) {
            if (points.get(i).equals(last)) {
                return Optional.of(new Shown(track, new WorldLine(points, before.line()), i));
            }
        }
        return Optional.empty();
    }

    @Override
    protected void paintStill(MapPaint paint) {
        tracks.replaceAll((id, shown) -> shown.whole());
        paint.g().setStroke(STROKE);
        tracks.values().forEach(shown -> paint.paint(shown.track().id(), () -> paintWhole(paint, shown)));
    }

    private static void paintWhole(MapPaint paint, Shown shown) {
        int last = shown.line().size() - 1;
        for (int shade = 1; shade <= SHADES && last > 0 && shown.line().isNear(paint.frame()); shade++) {
            int from = last * (shade - 1) / SHADES;
            int to = last * shade / SHADES;
            if (to > from) {
                Path2D part = shown.line().path(paint.frame(), from, to);
                Casing.draw(paint, part, shade(paint, shown, shade), STROKE);
                paint.g().draw(part);
            }
        }
    }

    @Override
    protected void paint(MapPaint paint) {
        paint.g().setStroke(STROKE);
        tracks.values().stream()
                .filter(Shown::hasGrown)
                .forEach(shown -> paint.paint(shown.track().id(), () -> {
                    int last = shown.line().size() - 1;
                    Color color = shade(paint, shown, SHADES);
                    if (paint.imagery()) {
                        paint.g().setColor(Casing.of(color));
                        paint.g().setStroke(Casing.stroke(STROKE));
                        shown.line().drawLegs(paint.g(), paint.frame(), shown.painted(), last);
                        paint.g().setStroke(STROKE);
                    }
                    paint.g().setColor(color);
                    shown.line().drawLegs(paint.g(), paint.frame(), shown.painted(), last);
                }));
    }

    /** On imagery the oldest part is fainter by less, so that it stays distinct from its casing. */
    private static Color shade(MapPaint paint, Shown shown, int shade) {
        double alpha = paint.imagery() ? 0.7 + 0.3 * shade / SHADES : 0.15 + 0.6 * shade / SHADES;
        return Painting.alpha(shown.track().mark().color(), alpha);
    }

    @Override
    public Optional<GeoBounds> bounds() {
        return tracks.values().stream()
                .flatMap(shown -> shown.line().bounds().stream())
                .reduce(GeoBounds::with);
    }
}
