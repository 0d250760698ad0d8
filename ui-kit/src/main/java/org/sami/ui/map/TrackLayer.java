package org.sami.ui.map;

import java.awt.BasicStroke;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.ui.geo.GeoBounds;

/** Tracks that fade: the older, the fainter. */
public final class TrackLayer extends MapLayer {
    private static final int SHADES = 5;
    private static final BasicStroke STROKE = new BasicStroke(2, BasicStroke.CAP_BUTT, BasicStroke.JOIN_BEVEL);

    private record Shown(Track track, WorldLine line) {}

    private Map<String, Shown> tracks = Map.of();

    public TrackLayer(String id, String title) {
        super(id, title);
    }

    /** Shows these tracks instead of those before. A track that is equal to the one before is not projected again. */
    public void show(List<Track> tracks) {
        Map<String, Shown> next = new LinkedHashMap<>();
        for (Track track : tracks) {
            Shown before = this.tracks.get(track.id());
            boolean same = before != null && before.track().equals(track);
            next.put(track.id(), same ? before : new Shown(track, new WorldLine(track.points())));
        }
        this.tracks = next;
        changed();
    }

    @Override
    protected void paint(MapPaint paint) {
        paint.g().setStroke(STROKE);
        tracks.values().forEach(shown -> paint.paint(shown.track().id(), () -> paint(paint, shown)));
    }

    private static void paint(MapPaint paint, Shown shown) {
        int last = shown.line().size() - 1;
        for (int shade = 1; shade <= SHADES && last > 0; shade++) {
            int from = last * (shade - 1) / SHADES;
            int to = last * shade / SHADES;
            if (to > from) {
                paint.g().setColor(Painting.alpha(shown.track().mark().color(), 0.15 + 0.6 * shade / SHADES));
                paint.g().draw(shown.line().path(paint.frame(), from, to));
            }
        }
    }

    @Override
    public Optional<GeoBounds> bounds() {
        return tracks.values().stream()
                .flatMap(shown -> shown.line().bounds().stream())
                .reduce(GeoBounds::with);
    }
}
