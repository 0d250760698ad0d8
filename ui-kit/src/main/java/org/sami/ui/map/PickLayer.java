package org.sami.ui.map;

import java.awt.BasicStroke;
import java.awt.Graphics2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.util.List;
import org.sami.palette.SemanticColor;
import org.sami.spn.value.GeoPoint;

/** Rings with a check mark around what is chosen on a map: seen whatever else is dimmed. */
public final class PickLayer extends MapLayer {
    private static final double RADIUS_PX = 17;
    private static final double MARK_PX = 5;

    private List<GeoPoint> places = List.of();

    /**
     * A layer on which nothing is chosen.
     *
     * @param id stable, unique on its map
     * @param title what people call it
     */
    public PickLayer(String id, String title) {
        super(id, title);
    }

    /** Marks these places, and no others. */
    public void show(List<GeoPoint> chosen) {
        if (!places.equals(chosen)) {
            places = List.copyOf(chosen);
            changed();
        }
    }

    /** The places that are marked. */
    public List<GeoPoint> places() {
        return places;
    }

    @Override
    protected void paint(MapPaint paint) {
        places.forEach(
                place -> ring(paint, paint.frame().px(place), paint.frame().py(place)));
    }

    private static void ring(MapPaint paint, double x, double y) {
        Graphics2D g = paint.g();
        double r = Painting.px(RADIUS_PX);
        Ellipse2D ring = new Ellipse2D.Double(x - r, y - r, 2 * r, 2 * r);
        g.setColor(SemanticColor.MAP_HALO.get());
        g.setStroke(Painting.line(5));
        g.draw(ring);
        g.setColor(SemanticColor.ACCENT.get());
        g.setStroke(Painting.line(2.5));
        g.draw(ring);
        paint.labels().add(x - r, y - r, 2 * r, 2 * r);
        double m = Painting.px(MARK_PX);
        double markX = x + r * 0.7;
        double markY = y - r * 0.7;
        g.fill(new Ellipse2D.Double(markX - 1.6 * m, markY - 1.6 * m, 3.2 * m, 3.2 * m));
        Path2D check = new Path2D.Double();
        check.moveTo(markX - 0.8 * m, markY);
        check.lineTo(markX - 0.2 * m, markY + 0.6 * m);
        check.lineTo(markX + 0.8 * m, markY - 0.7 * m);
        g.setColor(SemanticColor.MAP_HALO.get());
        g.setStroke(new BasicStroke(Painting.px(1.6), BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
        g.draw(check);
    }
}
