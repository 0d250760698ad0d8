package org.sami.crw.service.coverage;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.locationtech.jts.geom.Envelope;
import org.locationtech.jts.geom.Geometry;
import org.locationtech.jts.geom.GeometryFactory;
import org.locationtech.jts.geom.Polygon;
import org.locationtech.jts.operation.overlayng.OverlayNG;
import org.locationtech.jts.operation.overlayng.OverlayNGRobust;

/**
 * Takes many shapes off a region: strip by strip, on all cores. How many strips there are follows from the number of shapes alone, so that every machine
 * gets the same.
 */
final class StripDifference {
    private static final int SHAPES_OF_STRIP = 48;
    private static final int MOST_STRIPS = 8;
    private static final double ROUNDING_M = 1e-6;
    private static final GeometryFactory FACTORY = new GeometryFactory();

    private final Geometry region;
    private final List<Geometry> shapes;
    private final int strips;
    private final boolean isAcrossX;

    private StripDifference(Geometry region, List<Geometry> shapes) {
        this.region = region;
        this.shapes = shapes;
        strips = Math.max(1, Math.min(MOST_STRIPS, shapes.size() / SHAPES_OF_STRIP));
        isAcrossX = shapes.stream()
                        .map(Geometry::getEnvelopeInternal)
                        .mapToDouble(box -> box.getWidth() - box.getHeight())
                        .sum()
                < 0;
    }

    /** All points of a region that are in none of the shapes, of which there is one at least. */
    static Geometry of(Geometry region, List<Geometry> shapes) {
        return new StripDifference(region, shapes).rest();
    }

    private Geometry rest() {
        if (strips == 1) {
            return OverlayNGRobust.overlay(region, OverlayNGRobust.union(shapes), OverlayNG.DIFFERENCE);
        }
        return joined(IntStream.range(0, strips)
                .parallel()
                .mapToObj(strip -> rest(box(strip)))
                .toList());
    }

    private Geometry rest(Envelope box) {
        Geometry part = OverlayNGRobust.overlay(region, FACTORY.toGeometry(box), OverlayNG.INTERSECTION);
        List<Geometry> near = shapes.stream()
                .filter(shape -> shape.getEnvelopeInternal().intersects(box))
                .toList();
        return near.isEmpty() ? part : OverlayNGRobust.overlay(part, OverlayNGRobust.union(near), OverlayNG.DIFFERENCE);
    }

    /** Strips lie along the shapes, so that few of these reach into two of them. */
    private Envelope box(int strip) {
        Envelope all = region.getEnvelopeInternal();
        return isAcrossX
                ? new Envelope(cut(strip), cut(strip + 1), all.getMinY(), all.getMaxY())
                : new Envelope(all.getMinX(), all.getMaxX(), cut(strip), cut(strip + 1));
    }

    private double cut(int strip) {
        Envelope all = region.getEnvelopeInternal();
        return isAcrossX
                ? all.getMinX() + all.getWidth() * strip / strips
                : all.getMinY() + all.getHeight() * strip / strips;
    }

    /** The parts of all strips; what a cut has parted becomes one again, and only there is anything to be joined. */
    private Geometry joined(List<Geometry> rests) {
        List<Polygon> parts = new ArrayList<>();
        List<Geometry> atCuts = new ArrayList<>();
        for (Geometry rest : rests) {
            for (Polygon part : polygons(rest)) {
                if (isAtCut(part.getEnvelopeInternal())) {
                    atCuts.add(part);
                } else {
                    parts.add(part);
                }
            }
        }
        if (!atCuts.isEmpty()) {
            parts.addAll(polygons(OverlayNGRobust.union(atCuts)));
        }
        return FACTORY.createMultiPolygon(parts.toArray(Polygon[]::new));
    }

    private boolean isAtCut(Envelope part) {
        double from = isAcrossX ? part.getMinX() : part.getMinY();
        double to = isAcrossX ? part.getMaxX() : part.getMaxY();
        return IntStream.range(1, strips)
                .mapToDouble(this::cut)
                .anyMatch(cut -> from - ROUNDING_M <= cut && cut <= to + ROUNDING_M);
    }

    private static List<Polygon> polygons(Geometry geometry) {
        List<Polygon> polygons = new ArrayList<>();
        for (int i = 0; i < geometry.getNumGeometries(); i++) {
            if (geometry.getGeometryN(i) instanceof Polygon polygon && !polygon.isEmpty()) {
                polygons.add(polygon);
            }
        }
        return polygons;
    }
}
